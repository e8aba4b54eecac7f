// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/friction_law.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/laws/friction/coulomb_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::laws {
namespace {

template <class Law> FrictionLaw friction_row(std::string_view name) {
  return {name, declared_parameters<Law>(), [](double coefficient, const LawValues& values) {
            const Law law = law_with<Law>(coefficient, values);
            return Friction{"", coefficient,
                            [law](const FrictionArguments& at) { return law.limit(at); },
                            [law](const FrictionArguments& at) { return law.limit_slope(at); }};
          }};
}

} // namespace

std::span<const FrictionLaw> friction_laws() {
  static const std::array laws{
      friction_row<CoulombFriction>("coulomb"),
  };
  return laws;
}

Friction friction(std::string_view law, double coefficient, const LawValues& values) {
  const auto laws = friction_laws();
  const auto found = std::ranges::find(laws, law, &FrictionLaw::name);
  if (found == laws.end()) {
    throw InternalError("no friction law is named " + std::string(law));
  }
  Friction result = found->with(coefficient, values);
  result.law = found->name;
  return result;
}

std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit) {
  const double length = std::hypot(traction[0], traction[1]);
  if (length <= limit) {
    return traction;
  }
  return {traction[0] * limit / length, traction[1] * limit / length};
}

} // namespace ionskin::laws
