// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live::fmu {

/// Type of a variable in FMI 2.0.
enum class Kind { real, integer, boolean };
/// Role of a variable in FMI 2.0.
enum class Causality { input, parameter, output };

/// Variable of the FMU. Its value reference is its index in the list of `variables`.
struct Variable {
  std::string name;
  Kind kind = Kind::real;
  Causality causality = Causality::output;
  std::string unit; ///< empty for dimensionless
  std::string description;
  double start = 0; ///< start value; not used for outputs
};

/// Value references of FMI 2.0, which are indices in the list of `variables`: x, y, height, force,
/// friction, force_control and flags, then the signals of the skin from `signals` on, then the
/// trained angles. The first `inputs` of them are the real inputs other than angles.
namespace reference {
inline constexpr std::size_t x = 0, y = 1, height = 2, force = 3, friction = 4, inputs = 5,
                             force_control = 5, flags = 6, signals = 7;
} // namespace reference

/// Variables of the FMU, in the order of their value references: inputs, the parameter
/// `force_control`, flags, the signals of the skin in its order, then the trained angles.
std::vector<Variable> variables(const SkinData& data);

/// Indices of the angles that are inputs: roll and pitch (0, 1) if a tilt was trained, yaw (2) if a
/// rotation about z was. Empty if neither was.
std::vector<std::size_t> trained_angles(const SkinData& data);

} // namespace ionskin::live::fmu
