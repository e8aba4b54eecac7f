// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live::fmu {

/// Type of a variable in FMI 2.0.
enum class Kind { real, integer, boolean };
enum class Causality { input, parameter, output };

/// A variable of the FMU. Its value reference is its place in the list.
struct Variable {
  std::string name;
  Kind kind = Kind::real;
  Causality causality = Causality::output;
  std::string unit; ///< empty for 1
  std::string description;
  double start = 0; ///< unless an output
};

/// Value references.
namespace reference {
inline constexpr std::size_t x = 0, y = 1, height = 2, force = 3, friction = 4, inputs = 5,
                             force_control = 5, flags = 6, signals = 7;
} // namespace reference

/// Inputs and the parameter, flags, then the signals of a skin in its order.
std::vector<Variable> variables(const SkinData& data);

} // namespace ionskin::live::fmu
