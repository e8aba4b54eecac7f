// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/train.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/live/live_contact.hpp"
#include "ionskin/live/training/channel_reduction.hpp"
#include "ionskin/live/training/full_run.hpp"
#include "ionskin/live/training/random_touches.hpp"
#include "ionskin/live/training/stated_errors.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/results/build_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace ionskin::live {
namespace {

constexpr std::size_t least_rates = 5, most_rates = 12;
constexpr std::size_t candidate_rates = 20;
constexpr std::size_t least_validation = 12;                        // touches that tell the errors
constexpr std::uint64_t validation_seed_shift = 0x9e3779b97f4a7c15; // apart from every small seed

/// From the slowest motion of ions through the core to the fastest in a double layer [1/s].
std::vector<double> rate_candidates(const Case& input) {
  const double thickness = input.skin.core_thickness();
  const auto scales = electrochemistry::derive_scales(input.electrochemistry, thickness);
  const double slowest = 0.3 * std::numbers::pi * std::numbers::pi *
                         input.electrochemistry.diffusivity / (thickness * thickness),
               fastest = 3 / scales.relaxation_time;
  std::vector<double> rates;
  for (std::size_t i = 0; i < candidate_rates; ++i) {
    rates.push_back(slowest *
                    std::pow(fastest / slowest, static_cast<double>(i) / (candidate_rates - 1)));
  }
  return rates;
}

/// Each activity of a run gets its part of the whole, which goes on over both runs.
base::ProgressCallback part_of(const base::ProgressCallback& progress, const std::string& part) {
  return [&progress, part](std::string_view activity, double fraction) {
    progress(part + ": " + std::string(activity), fraction);
  };
}

void set_contact(const FullRun& run, const mechanics::PositionNodes& nodes, SkinData& data) {
  const mechanics::SkinModel& model = nodes.model();
  data.area = model.cells.area;
  data.gap = model.gap;
  data.compliance = reduce_compliance(nodes);
  data.meshed_share = model.mesh.half_model() ? 0.5 : 1;
  // Of the heaviest state by a secant to the lightest within a part of it.
  double heavy_force = 0, heavy_indentation = 0, light_force = 0, light_indentation = 0;
  for (const auto& instant : run.contact.stepped) {
    if (instant.state && instant.state->normal_force > heavy_force) {
      heavy_force = instant.state->normal_force;
      heavy_indentation = instant.state->indentation;
    }
  }
  for (const auto& instant : run.contact.stepped) {
    if (instant.state && instant.state->normal_force < 0.9 * heavy_force &&
        instant.state->normal_force > light_force) {
      light_force = instant.state->normal_force;
      light_indentation = instant.state->indentation;
    }
  }
  data.stiffness =
      data.meshed_share * (heavy_force - light_force) / (heavy_indentation - light_indentation);
  data.heaviest_force = heavy_force;
  for (const auto& instant : run.contact.stepped) {
    data.deepest_indentation =
        std::max(data.deepest_indentation, instant.state ? instant.state->indentation : 0.0);
  }
}

void set_charges(const FullRun& run, SkinData& data) {
  const auto whole = charge_records(run, false);
  data.rates = choose_rates(whole, drive_inputs(run, false), rate_candidates(run.input),
                            least_rates, most_rates);
  data.whole = fit_charges(whole, drive_inputs(run, false), data.rates);
  data.part = data.whole;
  for (const Taxel& taxel : run.input.readout.taxels) {
    data.taxels.push_back(taxel.name);
    data.taxel_corners.insert(data.taxel_corners.end(),
                              {taxel.lower[0], taxel.lower[1], taxel.upper[0], taxel.upper[1]});
  }
  if (!data.taxels.empty()) {
    data.part = fit_charges(charge_records(run, true), drive_inputs(run, true), data.rates);
  }
}

} // namespace

void check_trainable(const Case& input) {
  if (input.strain.kind != StrainSourceKind::contact) {
    throw UserError("strain.source: a live skin is stepped by contact, and this case has none\n"
                    "  = set strain.source = \"contact\"");
  }
  if (input.readout.circuit != circuits::circuits().front().name) {
    throw UserError("readout.circuit: a live skin knows shorted electrodes alone\n"
                    "  = set readout.circuit = \"short\"");
  }
  if (friction_remembers(laws::friction(input.contact.law, 1, input.contact.parameters))) {
    throw UserError(
        fmt::format("contact.law = \"{}\": a live skin knows no friction that remembers "
                    "the slip of earlier steps\n  = set contact.law = \"coulomb\", or "
                    "another law without slip_length or lag_time",
                    input.contact.law));
  }
  if (laws::friction_law(input.contact.law).adheres) {
    throw UserError(
        fmt::format("contact.law = \"{}\": a live skin knows no pull between slider and skin\n  "
                    "= set contact.law = \"coulomb\"",
                    input.contact.law));
  }
  if (input.motion.drive.given()) {
    throw UserError(
        "motion.drive: a live skin is told where the slider is, and knows no drive that "
        "gives\n  = remove motion.drive, and give each step the place of the slider");
  }
  touch_range(input);
}

SkinData train_skin(const Case& input, const TrainingOptions& options) {
  check_trainable(input);
  const TouchRange range = touch_range(input);
  SkinData data;
  data.case_text = input.text;
  data.version = results::build_info::version;
  data.command = options.command;
  data.seed = options.seed;
  data.trajectories = options.trajectories;
  data.friction_law = input.contact.law;
  data.friction = input.contact.friction;
  for (const auto& [name, value] : input.contact.parameters) {
    data.friction_parameters.push_back(name);
    data.friction_values.push_back(value);
  }
  data.direction = slide_direction(motion_legs(input.motion, input.slider));
  data.length = input.skin.length;
  data.width = input.skin.width;
  data.thickness = input.skin.core_thickness();
  data.lowest_place = range.box.low;
  data.highest_place = range.box.high;
  data.fastest = range.fastest;

  TrainingOptions own = options;
  own.progress = part_of(options.progress, "training");
  const FullRun run = full_run(
      input, with_rows_behind_corners(random_touches(range, options.trajectories, options.seed)),
      std::nullopt, own);
  {
    mechanics::SharedProgress progress("positions", own.progress);
    const auto model = std::make_shared<const mechanics::SkinModel>(
        run.input, run.contact.mesh.footprint(), mesh::MeshedPart::half_if_symmetric);
    const mechanics::PositionNodes nodes(run.input, model, range.box,
                                         {options.threads, options.cache, 0}, progress);
    std::vector<std::string> channels{history::channel_name::shear};
    if (moves_water(input)) {
      channels.emplace_back(electrochemistry::driving_channel(run.input, run.history).name);
    }
    set_contact(run, nodes, data);
    data.channels = reduce_channels(run.input, run.contact, run.history, nodes, channels);
  }
  set_charges(run, data);

  own.progress = part_of(options.progress, "validation");
  data.errors = stated_errors(errors_on_touches(data, input, range, options.validation,
                                                options.seed + validation_seed_shift,
                                                run.contact.mesh.footprint(), own));
  return data;
}

} // namespace ionskin::live
