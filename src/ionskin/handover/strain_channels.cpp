// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/strain_channels.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/handover/measures/compressive_dilation.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::handover {

PointStrain strain_at_points(const StateCombination& combination) {
  PointStrain strain;
  for (const auto& term : combination.terms) {
    const mechanics::CoreStrain& own = mechanics::core_strain(*term.state);
    for (std::size_t c = 0; c < 6; ++c) {
      strain[c].resize(own.component[c].size(), 0.0);
      for (std::size_t i = 0; i < own.component[c].size(); ++i) {
        strain[c][i] += term.weight * own.component[c][i];
      }
    }
  }
  return strain;
}

std::vector<ChannelRule> channel_rules(const Case& input) {
  std::vector<ChannelRule> rules{
      {history::channel_name::shear,
       [measure = laws::shear_measure(input.coupling.measure)](const PointStrain& strain) {
         return laws::evaluate_shear(measure, strain);
       }}};
  if (moves_water(input)) {
    rules.push_back({history::channel_name::dilation, compressive_dilation});
  }
  return rules;
}

void require_finite(const history::StrainField& field, const Case& input, double time) {
  const auto bad = static_cast<std::size_t>(std::count_if(
      field.begin(), field.end(), [](double value) { return !std::isfinite(value); }));
  if (bad > 0) {
    throw SolverError(
        fmt::format(
            "the contact under the friction law \"{}\" (contact.friction = {:.4g}) ended in a "
            "strain that is not a finite number, in {} of {} cells at t = {:.4g} s",
            input.contact.law, input.contact.friction, bad, field.size(), time),
        "check the friction law and the materials, or change numerics.mesh_refinement");
  }
}

} // namespace ionskin::handover
