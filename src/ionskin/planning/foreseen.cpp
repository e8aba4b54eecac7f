// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/foreseen.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/percent.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/mechanics/solve_sliders.hpp"
#include "ionskin/planning/contact_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ionskin::planning {
namespace {

constexpr double large_indentation = 0.2; // limit of the indentation over the skin's thickness
constexpr double least_response = 0.1;    // shortest run over the ions' relaxation time

/// Smallest and largest fixed charge under the coupling law, relative to the charge at rest [1].
/// Below the slider the core is sheared by `shear` at its top and by half of it at its bottom;
/// beside the slider it is not sheared.
struct ChargeRange {
  double least = 1, largest = 1;
};

ChargeRange charge_range(const Case& input, double shear, double loaded_share) {
  const laws::Coupling law = laws::coupling_law(input.coupling.law)
                                 .with(input.coupling.coefficient, input.coupling.parameters);
  if (!law)
    return {};
  constexpr std::size_t most_columns = 1000;
  const auto columns = static_cast<std::size_t>(
      std::clamp(std::round(1 / loaded_share), 1.0, static_cast<double>(most_columns)));
  const std::array<double, 2> height{0.5, 0.5};
  std::vector<double> gamma(2 * columns, 0.0), ratio(2 * columns, 1.0);
  gamma[0] = 0.5 * shear;
  gamma[columns] = shear;
  law({columns, 2, height, 1.0}, gamma, ratio);
  const auto [least, largest] = std::ranges::minmax(ratio);
  return {least, largest};
}

/// Sentence on a fixed charge, or a released amount of ions, that cannot exist under a shear; empty
/// where all is well.
/// @param shear of the core at its top below the slider [1]
/// @param loaded_share contact area over the area of the skin [1]
std::string impossible_charge(const Case& input, double shear, double loaded_share) {
  const ChargeRange range = charge_range(input, shear, loaded_share);
  if (range.least < 0.0)
    return fmt::format("the fixed charge becomes negative: {:.3g} times that at rest under a shear "
                       "of {:.2g}, which is estimated\n  = make coupling.coefficient smaller in "
                       "magnitude (now {:.4g}), or press and rub with less",
                       range.least, shear, input.coupling.coefficient);
  const auto excess = electrochemistry::steric_excess(input.electrochemistry);
  if (excess && laws::coupling_law(input.coupling.law).traits.releases_ions &&
      excess->room(range.largest) <= 0.0)
    return fmt::format("the law \"{}\" releases more cations than there is room for: {:.4g} times "
                       "those at rest under a shear of {:.2g}, which is estimated\n  = make "
                       "coupling.coefficient smaller in magnitude (now {:.4g}), or "
                       "electrochemistry.largest_concentration larger",
                       input.coupling.law, range.largest, shear, input.coupling.coefficient);
  if (const auto reason = electrochemistry::no_sane_solution(input, shear * loaded_share))
    return fmt::format("{}; the shear is estimated\n  = {}", *reason,
                       electrochemistry::no_sane_solution_remedy());
  return "";
}

void judge_charge(const Case& input, const ContactEstimate& contact,
                  std::vector<std::string>& warnings) {
  const double share = std::min(contact.area / (input.skin.length * input.skin.width), 1.0);
  const bool has_sign = input.coupling.measure == "signed-xz";
  if (!has_sign) {
    if (const std::string sure = impossible_charge(input, contact.least_shear, share);
        !sure.empty())
      throw UserError(sure);
  }
  std::string likely = impossible_charge(input, contact.shear, share);
  if (likely.empty() && has_sign)
    likely = impossible_charge(input, -contact.shear, share);
  if (!likely.empty())
    warnings.push_back(likely);
}

/// Longest uninterrupted contact within one cycle [s].
double longest_touch(const Case& input) {
  double longest = 0, time = 0;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    time = leg.touches() ? (leg.lands() ? 0.0 : time) + contact_part(leg).duration : 0.0;
    longest = std::max(longest, time);
  }
  return longest;
}

void judge_times(const Case& input, std::vector<std::string>& warnings) {
  const double touch = longest_touch(input);
  if (input.readout.sample_interval > touch)
    warnings.push_back(
        fmt::format("the touch is over within one sample: it lasts {:.3g} s, and "
                    "readout.sample_interval is {:.3g} s\n  = sample at least ten times a touch",
                    touch, input.readout.sample_interval));
  const double relaxation =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())
          .relaxation_time;
  const double run = input.motion.cycles * input.motion.cycle_duration();
  if (run < least_response * relaxation)
    warnings.push_back(fmt::format(
        "the ions hardly move: the run lasts {:.3g} s, and they relax within {:.3g} s (lambda^2 / "
        "D)\n  = let the run last longer, or check electrochemistry.diffusivity and permittivity",
        run, relaxation));
}

/// Adds the warnings on one slider, as if it were the only one on the skin.
/// @param name of the slider, put before each warning; empty for the only slider
/// @param found footprint of its contact from a coarse solution; empty to estimate it
void judge_slider(const Case& input, const std::string& name,
                  const std::optional<mesh::Footprint>& found, std::vector<std::string>& warnings) {
  std::vector<std::string> own;
  const ContactEstimate contact = estimate_contact(input, found);
  judge_charge(input, contact, own);
  judge_times(input, own);
  const double indentation = mesh::heaviest_load(input).indentation / input.skin.thickness();
  if (indentation > large_indentation)
    own.push_back(
        fmt::format("the slider indents by {} of the skin's thickness, and strains are taken as "
                    "small\n  = indent by less than {} (motion.preload, or the waypoints' height)",
                    base::percent(indentation), base::percent(large_indentation)));
  for (const std::string& warning : own)
    warnings.push_back(name + warning);
}

} // namespace

std::vector<std::string> foreseen(const Case& input, const std::optional<mesh::Footprint>& found) {
  std::vector<std::string> warnings;
  if (input.strain.kind != StrainSourceKind::contact)
    return warnings;
  if (!moves_water(input) && input.coupling.coefficient == 0.0)
    warnings.push_back("no current will flow: coupling.coefficient is 0\n  = give it another "
                       "value, or leave Study 2 out (run --only mechanics)");
  if (input.further_sliders.empty()) {
    judge_slider(input, "", found, warnings);
    return warnings;
  }
  const std::vector<Case> sliders = cases_of_sliders(input);
  mechanics::require_sliders_apart(sliders);
  for (std::size_t i = 0; i < sliders.size(); ++i)
    judge_slider(sliders[i], fmt::format("slider[{}]: ", i), std::nullopt, warnings);
  return warnings;
}

} // namespace ionskin::planning
