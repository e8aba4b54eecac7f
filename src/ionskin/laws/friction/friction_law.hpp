// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/law_parameter.hpp"

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::laws {

/// What a friction law may depend on at one cell over one step. In steady sliding, the limit of
/// long sliding, slip increment and time step are both 0: a law in their quotient must say there
/// what it tends to.
struct FrictionArguments {
  double normal_traction = 0; ///< compression positive [Pa]
  double slip_increment = 0;  ///< length of the relative sliding in the step [m]
  double time_step = 0;       ///< [s]
};

inline double frictionless(const FrictionArguments&) {
  return 0;
}

/// A law with its coefficient and parameters: the largest tangential traction [Pa] and its
/// derivative by the normal traction [1]. Without a coefficient there is no friction under any law.
struct Friction {
  std::string_view law = "coulomb";
  double coefficient = 0; ///< mu [1]
  std::function<double(const FrictionArguments& at)> limit = frictionless;
  std::function<double(const FrictionArguments& at)> limit_slope = frictionless;
};

/// One row of the table of friction laws.
struct FrictionLaw {
  std::string_view name; ///< that a case gives in `contact.law`
  std::span<const LawParameter> parameters;
  Friction (*with)(double coefficient, const LawValues& values);
};

/// All laws; the first is the default of a case.
std::span<const FrictionLaw> friction_laws();

/// The law of a name that the schema has checked, with its coefficient and parameters.
Friction friction(std::string_view law, double coefficient, const LawValues& values);

/// The nearest vector of length at most `limit`.
std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit);

} // namespace ionskin::laws
