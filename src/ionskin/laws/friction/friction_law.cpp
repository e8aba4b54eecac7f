// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/friction_law.hpp"

#include "ionskin/laws/friction/adhesive_friction.hpp"
#include "ionskin/laws/friction/anisotropic_friction.hpp"
#include "ionskin/laws/friction/coulomb_friction.hpp"
#include "ionskin/laws/friction/regularised_friction.hpp"
#include "ionskin/laws/friction/saturating_friction.hpp"
#include "ionskin/laws/friction/stribeck_friction.hpp"
#include "ionskin/laws/friction/viscous_friction.hpp"
#include "ionskin/laws/named_row.hpp"

#include <array>

namespace ionskin::laws {
namespace {

// The member functions that a law has show which features it has beside its limit.
template <class Law>
concept HasSlipSlope = requires(const Law& law, const FrictionArguments& at) {
  law.limit_slip_slope(at);
};
template <class Law>
concept HasElasticSlip = requires(const Law& law) {
  law.elastic_slip();
};
template <class Law>
concept HasLag = requires(const Law& law) {
  law.lag();
};
template <class Law>
concept HasAcross = requires(const Law& law) {
  law.across();
};
template <class Law>
concept HasAdhesion = requires(const Law& law) {
  law.adhesion();
};

template <class Law> Friction friction_with(double coefficient, const LawValues& values) {
  const Law law = law_with<Law>(coefficient, values);
  Friction result;
  result.coefficient = coefficient;
  if constexpr (HasAdhesion<Law>) {
    result.adhesion = law.adhesion();
  }
  if (coefficient == 0) {
    return result;
  }
  result.limit = [law](const FrictionArguments& at) { return law.limit(at); };
  result.limit_slope = [law](const FrictionArguments& at) { return law.limit_slope(at); };
  if constexpr (HasSlipSlope<Law>) {
    result.limit_slip_slope = [law](const FrictionArguments& at) {
      return law.limit_slip_slope(at);
    };
  }
  result.slip_dependent = HasSlipSlope<Law>;
  if constexpr (HasElasticSlip<Law>) {
    result.elastic_slip = law.elastic_slip();
  }
  if constexpr (HasLag<Law>) {
    result.lag = law.lag();
  }
  if constexpr (HasAcross<Law>) {
    result.across = law.across();
  }
  result.rate_dependent = HasLag<Law> || (HasSlipSlope<Law> && !HasElasticSlip<Law>);
  return result;
}

template <class Law> FrictionLaw friction_row(std::string_view name) {
  return {name, declared_parameters<Law>(), HasAdhesion<Law>, friction_with<Law>};
}

} // namespace

bool is_proportional(const Friction& friction) {
  if (friction.rate_dependent || friction.elastic_slip != 0) {
    return false;
  }
  // Factors of 2 leave a proportional limit exact; a law may change its coefficient anywhere.
  constexpr double lowest = 1, highest = 1e12; // Pa
  for (double pressure = lowest; pressure < highest; pressure *= 2) {
    if (2 * friction.limit({.normal_traction = pressure}) !=
        friction.limit({.normal_traction = 2 * pressure})) {
      return false;
    }
  }
  return true;
}

std::span<const FrictionLaw> friction_laws() {
  static const std::array laws{
      friction_row<CoulombFriction>("coulomb"),
      friction_row<SaturatingFriction>("saturating"),
      friction_row<RegularisedFriction>("regularised"),
      friction_row<ViscousFriction>("viscous"),
      friction_row<StribeckFriction>("stribeck"),
      friction_row<AnisotropicFriction>("anisotropic"),
      friction_row<AdhesiveFriction>("adhesive"),
  };
  return laws;
}

const FrictionLaw& friction_law(std::string_view name) {
  return named_row(friction_laws(), name, "friction law");
}

Friction friction(std::string_view law, double coefficient, const LawValues& values) {
  const FrictionLaw& row = friction_law(law);
  Friction result = row.with(coefficient, values);
  result.law = row.name;
  return result;
}

} // namespace ionskin::laws
