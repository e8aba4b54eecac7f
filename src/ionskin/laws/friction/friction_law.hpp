// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/cohesive_zone.hpp"
#include "ionskin/laws/law_parameter.hpp"

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::laws {

/// Arguments on which a friction law may depend at one cell over one step. In steady sliding, the
/// limit of long sliding, slip increment and time step are both 0: a law in their quotient must say
/// there what it tends to.
struct FrictionArguments {
  double normal_traction = 0; ///< compression positive [Pa]
  /// Length of the relative sliding in the step [m]; where the law has an elastic slip, with what
  /// is kept of that of the steps before (elastic_slip.hpp).
  double slip_increment = 0;
  double time_step = 0;    ///< [s]
  double lagged_speed = 0; ///< of the sliding, as it was `lag` ago [m/s]
};

inline double frictionless(const FrictionArguments&) {
  return 0;
}

/// A law with its coefficient and parameters: the largest tangential traction [Pa] and its
/// derivatives. Without a coefficient there is no friction under any law.
struct Friction {
  std::string_view law = "coulomb";
  double coefficient = 0; ///< mu [1]
  std::function<double(const FrictionArguments& at)> limit = frictionless;
  std::function<double(const FrictionArguments& at)> limit_slope =
      frictionless; ///< by the normal traction [1]
  std::function<double(const FrictionArguments& at)> limit_slip_slope =
      frictionless;            ///< by the slip increment [Pa/m]
  bool slip_dependent = false; ///< true if it is ever other than 0
  double across = 1;           ///< limit along y over that along x; the limits form an ellipse
  double elastic_slip = 0;     ///< the slip that is given back when the traction goes [m]
  double lag = 0;              ///< time constant with which the lagged speed follows the speed [s]
  bool rate_dependent = false; ///< traction changes while the slider rests
  CohesiveZone adhesion;       ///< pull along the normal, with or without a coefficient
};

/// One row of the table of friction laws.
struct FrictionLaw {
  std::string_view name; ///< value of `contact.law`
  std::span<const LawParameter> parameters;
  bool adheres = false; ///< true if it pulls along the normal
  Friction (*with)(double coefficient, const LawValues& values);
};

/// All laws; the first is the default of a case.
std::span<const FrictionLaw> friction_laws();

/// The row of a name that the schema has checked.
const FrictionLaw& friction_law(std::string_view name);

/// The law of a name that the schema has checked, with its coefficient and parameters.
Friction friction(std::string_view law, double coefficient, const LawValues& values);

} // namespace ionskin::laws
