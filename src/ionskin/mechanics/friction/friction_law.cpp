// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/friction/friction_law.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/friction/coulomb_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::mechanics {
namespace {

template <typename Law> constexpr FrictionLaw row(std::string_view name) {
  return {
      name,
      [](double coefficient, const FrictionArguments& at) { return Law{coefficient}.limit(at); },
      [](double coefficient, const FrictionArguments& at) {
        return Law{coefficient}.limit_slope(at);
      }};
}

constexpr std::array laws{
    row<CoulombFriction>("coulomb"),
};

} // namespace

const FrictionLaw& friction_law(const std::string& name) {
  const auto found = std::find_if(laws.begin(), laws.end(),
                                  [&](const FrictionLaw& law) { return law.name == name; });
  if (found == laws.end()) {
    throw InternalError("no friction law is named " + name);
  }
  return *found;
}

std::array<double, 2> project_on_disc(const std::array<double, 2>& traction, double limit) {
  const double length = std::hypot(traction[0], traction[1]);
  if (length <= limit) {
    return traction;
  }
  return {traction[0] * limit / length, traction[1] * limit / length};
}

} // namespace ionskin::mechanics
