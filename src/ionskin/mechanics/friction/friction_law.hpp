// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace ionskin::mechanics {

/// What a friction law may depend on at one cell over one step. In steady sliding, the limit of
/// long sliding, slip increment and time step are both 0: a law in their quotient must say there
/// what it tends to.
struct FrictionArguments {
  double normal_traction = 0; ///< compression positive [Pa]
  double slip_increment = 0;  ///< length of the relative sliding in the step [m]
  double time_step = 0;       ///< [s]
};

/// One row of the table of friction laws: the name that a case gives in `contact.law`, and the
/// largest tangential traction [Pa] with its derivative by the normal traction [1], both under the
/// coefficient `contact.friction`.
struct FrictionLaw {
  std::string_view name;
  double (*limit)(double coefficient, const FrictionArguments& at);
  double (*limit_slope)(double coefficient, const FrictionArguments& at);
};

/// The law of a name that the schema has checked.
const FrictionLaw& friction_law(const std::string& name);

/// A law with its coefficient.
struct Friction {
  double coefficient = 0; ///< mu [1]; without it there is no friction under any law
  const FrictionLaw* law = &friction_law("coulomb");

  double limit(const FrictionArguments& at) const { return law->limit(coefficient, at); }
  double limit_slope(const FrictionArguments& at) const {
    return law->limit_slope(coefficient, at);
  }
};

/// The nearest vector of length at most `limit`.
std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit);

} // namespace ionskin::mechanics
