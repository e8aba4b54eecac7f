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

/// Arguments of a friction law: state of one contact cell over one step. In steady sliding both
/// slip increment and time step are 0, so a law that depends on their quotient (the slip speed)
/// must return its limit for long sliding at a time step of 0.
struct FrictionArguments {
  double normal_traction = 0; ///< compression positive [Pa]
  /// Length of the slip in the step; under a law with elastic slip, length of the updated elastic
  /// slip, which includes the kept part of earlier steps (elastic_slip.hpp) [m].
  double slip_increment = 0;
  double time_step = 0; ///< duration of the step [s]
  /// Slip speed that follows the true one with the time constant `Friction::lag` [m/s].
  double lagged_speed = 0;
};

/// Friction limit of a frictionless contact: 0 for all arguments [Pa].
inline double frictionless(const FrictionArguments&) {
  return 0;
}

/// Friction law with its coefficient and parameters filled in: the largest tangential traction (the
/// limit) and its derivatives. With a coefficient of 0 every law is frictionless.
struct Friction {
  std::string_view law = "coulomb"; ///< value of the key `contact.law`
  double coefficient = 0;           ///< mu [1]
  /// Largest tangential traction [Pa]; along x where friction is anisotropic.
  std::function<double(const FrictionArguments& at)> limit = frictionless;
  /// Derivative of the limit with respect to the normal traction [1].
  std::function<double(const FrictionArguments& at)> limit_slope = frictionless;
  /// Derivative of the limit with respect to the slip increment [Pa/m].
  std::function<double(const FrictionArguments& at)> limit_slip_slope = frictionless;
  bool slip_dependent = false; ///< true if `limit_slip_slope` may differ from 0
  double across = 1;           ///< ratio of the limit along y to the limit along x (ellipse) [1]
  double elastic_slip = 0;     ///< largest elastic slip of a cell [m]; 0: law without elastic slip
  double lag = 0;              ///< time constant of the lagged slip speed [s]; 0: no lag
  bool rate_dependent = false; ///< true if traction changes with time while the slider rests
  CohesiveZone adhesion;       ///< adhesion along the normal, also with a coefficient of 0
};

/// True if the limit is proportional to the pressure and depends on nothing else. The frictional
/// contact of a flat slider without adhesion is then proportional to its load.
bool is_proportional(const Friction& friction);

/// One row of the table of friction laws.
struct FrictionLaw {
  std::string_view name;                    ///< value of the key `contact.law`
  std::span<const LawParameter> parameters; ///< parameters of its own, beside the coefficient
  bool adheres = false;                     ///< true if the law has adhesion along the normal
  /// Creates the law from the friction coefficient mu [1] and its own parameters.
  Friction (*with)(double coefficient, const LawValues& values);
};

/// Table of all friction laws; the first is the default of a case.
std::span<const FrictionLaw> friction_laws();

/// Finds the row of a friction law by its name. Throws InternalError for an unknown name, which the
/// schema has excluded.
const FrictionLaw& friction_law(std::string_view name);

/// Creates a friction law by its name, with its coefficient mu [1] and its own parameters. Throws
/// InternalError for an unknown name.
Friction friction(std::string_view law, double coefficient, const LawValues& values);

} // namespace ionskin::laws
