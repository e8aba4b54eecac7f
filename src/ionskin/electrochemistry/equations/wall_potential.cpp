// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/wall_potential.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ionskin::electrochemistry {
namespace {

/// Potential [R T/(v F)] beyond which the concentration, exp(-600), is near the smallest number in
/// double precision.
constexpr double largest_potential = 600.0;

} // namespace

double depletion_potential(const DerivedScales& scales, double excess) {
  if (excess <= 0.0) {
    return 0.0;
  }
  const double layer = excess / (1.0 + excess) * scales.half_thickness; // [Debye lengths]
  return 0.5 * (1.0 + excess) * layer * layer * scales.potential_scale;
}

std::optional<std::string> no_sane_solution(const Case& input, double mean_shear) {
  if (!laws::coupling_law(input.coupling.law).traits.net_charge_is_linear) {
    return std::nullopt;
  }
  const DerivedScales scales = derive_scales(input.electrochemistry, input.skin.core_thickness());
  const double potential = depletion_potential(scales, input.coupling.coefficient * mean_shear);
  if (potential <= largest_potential * scales.potential_scale) {
    return std::nullopt;
  }
  return fmt::format(
      "the law \"{}\" has no sane solution here: a mean shear of {:.3g} puts a net charge "
      "of F c0 k integral(gamma) = {:.3g} C into the core, which depletes the electrodes of ions "
      "and needs at least {:.3g} V between core and electrodes (the Debye length is {:.3g} um, the "
      "core {:.4g} of them thick)",
      input.coupling.law, mean_shear,
      scales.charge_density / scales.debye_length * input.coupling.coefficient * mean_shear *
          input.skin.core_volume(),
      potential, scales.debye_length * 1e6, 2.0 * scales.half_thickness);
}

std::string no_sane_solution_remedy() {
  return "choose a law that conserves charge (coupling.law = \"column-neutral\", "
         "\"volume-neutral\" or \"pair-generation\"), a smaller coupling.coefficient, or a larger "
         "effective electrochemistry.permittivity";
}

void check_net_charge(const Case& input, const history::CoreHistory& history) {
  if (history.find(history::channel_name::shear) == nullptr) {
    return;
  }
  const double sign = input.coupling.coefficient < 0.0 ? -1.0 : 1.0;
  double largest = 0.0;
  for (const double time : history.time) {
    largest = std::max(largest, sign * history::shear_integral(history, time));
  }
  const double volume = history.length * history.width * history.core_thickness();
  if (const auto reason = no_sane_solution(input, sign * largest / volume)) {
    throw SolverError(*reason, no_sane_solution_remedy());
  }
}

} // namespace ionskin::electrochemistry
