// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/train.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/live/contact/live_contact.hpp"
#include "ionskin/live/data/slope_table.hpp"
#include "ionskin/live/errors/shortfall.hpp"
#include "ionskin/live/reduction/channel_reduction.hpp"
#include "ionskin/live/reduction/place_map.hpp"
#include "ionskin/live/training/charge_spread_fit.hpp"
#include "ionskin/live/training/contact_samples.hpp"
#include "ionskin/live/training/full_run.hpp"
#include "ionskin/live/training/stated_errors.hpp"
#include "ionskin/live/training/touch_range.hpp"
#include "ionskin/live/training/training_record.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"
#include "ionskin/results/build_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

namespace ionskin::live {
namespace {

constexpr std::size_t least_rates = 3, most_rates = 12;
constexpr std::size_t candidate_rates = 20;
constexpr std::size_t sampled_states = 600; // of the contact
/// Number of them under an underside that turns, whose strain differs more from state to state.
constexpr std::size_t sampled_turned_states = 1800;
constexpr std::size_t runs_over_friction = 3; // from its lowest to its highest
constexpr double even_lowest = 1e-4;          // of the deepest of the lowest points
constexpr double fastest_spin = 100;          // [rad/s]
constexpr int turned_gaps = 360;              // yaws of the table of gaps, a degree apart
constexpr double most_friction = 2;           // as in a case
constexpr std::uint64_t validation_seed_shift = 0x9e3779b97f4a7c15; // apart from every small seed

/// Candidates for rates, from the slowest motion of ions through the core to the fastest in a
/// double layer, and that at which both layers charge through the core [1/s].
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
  rates.push_back(1 / scales.slow_time);
  return rates;
}

/// Each activity of a run gets its part of the whole, which goes on over both runs.
base::ProgressCallback part_of(const base::ProgressCallback& progress, const std::string& part) {
  return [&progress, part](std::string_view activity, double fraction) {
    progress(part + ": " + std::string(activity), fraction);
  };
}

void set_contact(const std::vector<FullRun>& runs, const mechanics::SkinModel& model,
                 const PlaceNodes& places, SkinData& data) {
  data.cell_lines_x = model.cells.lines_x;
  data.cell_lines_y = model.cells.lines_y;
  data.area = model.cells.area;
  data.gap = model.gap;
  if (turns_underside(data)) {
    for (int at = 0; at < turned_gaps; ++at) {
      const shapes::Pose pose{0, 0, 2 * std::numbers::pi * at / turned_gaps};
      const std::vector<double> gap = mechanics::mean_gap(
          runs.front().input.slider, pose, data.cell_lines_x, data.cell_lines_y, {false, false});
      data.turned_gap.insert(data.turned_gap.end(), gap.begin(), gap.end());
    }
  }
  data.compliance = reduce_compliance(model, places);
  data.meshed_share = model.mesh.half_model() ? 0.5 : 1;
  std::vector<const mechanics::ContactState*> states;
  for (const FullRun& run : runs) {
    for (const auto& instant : run.contact.stepped) {
      if (instant.state) {
        states.push_back(instant.state.get());
      }
    }
  }
  // The load of the heaviest state is found by a secant to the heaviest within a part of it.
  double heavy_force = 0, heavy_indentation = 0, light_force = 0, light_indentation = 0;
  for (const mechanics::ContactState* state : states) {
    if (state->normal_force > heavy_force) {
      heavy_force = state->normal_force;
      heavy_indentation = state->indentation;
    }
    data.deepest_indentation = std::max(data.deepest_indentation, state->indentation);
  }
  for (const mechanics::ContactState* state : states) {
    if (state->normal_force < 0.9 * heavy_force && state->normal_force > light_force) {
      light_force = state->normal_force;
      light_indentation = state->indentation;
    }
  }
  data.stiffness =
      data.meshed_share * (heavy_force - light_force) / (heavy_indentation - light_indentation);
  data.heaviest_force = heavy_force;
}

void set_charges(const std::vector<FullRun>& runs, SkinData& data) {
  const FullRun& run = runs.front();
  std::vector<ChargeRecord> whole;
  std::vector<std::vector<ChargeRecord>> of_taxels;
  for (const FullRun& one : runs) {
    std::ranges::move(charge_records(one, false), std::back_inserter(whole));
    of_taxels.push_back(charge_records(one, true));
  }
  const std::vector<double> candidates = rate_candidates(run.input);
  const std::size_t inputs = drive_inputs(run, true);
  std::vector<ChargeGroup> groups{{std::move(whole), drive_inputs(run, false)}};
  data.rates = choose_rates(groups, candidates, least_rates, most_rates);
  for (const Taxel& taxel : run.input.readout.taxels) {
    data.taxels.push_back(taxel.name);
    data.taxel_corners.insert(data.taxel_corners.end(),
                              {taxel.lower[0], taxel.lower[1], taxel.upper[0], taxel.upper[1]});
  }
  if (!data.taxels.empty()) {
    data.spread = find_spread(runs, of_taxels, inputs, data.rates);
    groups.push_back({joined(of_taxels), inputs});
    data.rates = choose_rates(groups, candidates, least_rates, most_rates);
    ChargeFit fit = fit_charges(groups.back().records, inputs, data.rates);
    data.part = std::move(fit.model);
    data.spread.weights = std::move(fit.spread);
  }
  data.whole = fit_charges(groups.front().records, groups.front().inputs, data.rates).model;
  if (data.taxels.empty()) {
    data.part = data.whole;
  }
}

bool turns_into_itself(const Slider& slider) {
  return slider.underside()->turns_into_itself(slider.plan());
}

/// Trained poses, and how deep the lowest point of the underside lies on each slope.
void set_pose(const Case& input, const TrainingOptions& options, SkinData& data) {
  data.turns_into_itself = turns_into_itself(input.slider) ? 1 : 0;
  data.fastest_turn = options.turn;
  data.steepest = options.tilt;
  if (options.tilt == 0) {
    return;
  }
  const auto body = input.slider.underside();
  const shapes::Plan plan = input.slider.plan();
  const double upright = body->lowest(plan);
  const auto lowest = [&](double x, double y) {
    return body->lowest_on_slope(plan, {x, y}) - upright;
  };
  data.slopes = slope_lines(std::tan(options.tilt));
  for (const double y : data.slopes) {
    for (const double x : data.slopes) {
      data.lowest.push_back(lowest(x, y));
    }
  }
  const double deepest = -*std::ranges::min_element(data.lowest);
  for (std::size_t i = 0; i + 1 < data.slopes.size(); ++i) {
    for (std::size_t j = 0; j + 1 < data.slopes.size(); ++j) {
      const double x = (data.slopes[i] + data.slopes[i + 1]) / 2,
                   y = (data.slopes[j] + data.slopes[j + 1]) / 2;
      const double missed = std::abs(at_slope(data.slopes, data.lowest, {x, y}) - lowest(x, y));
      if (missed > even_lowest * deepest) {
        throw UserError(fmt::format(
            "--tilt {:g}: the lowest point of this underside jumps from place to place as it "
            "tilts, and a live skin supports only undersides on which it rolls\n  = take a smaller "
            "tilt, or another slider.shape",
            options.tilt * 180 / std::numbers::pi));
      }
    }
  }
}

/// Footprint of touches that tilt, or that turn an underside which does not look alike from all
/// sides, with contact cells as fine as those of an upright slider under the same loads. Empty, for
/// the touches themselves to find it, where there are none.
std::optional<mesh::Footprint> footprint_of_poses(const Case& input, const TouchRange& range,
                                                  const TrainingOptions& options) {
  if ((range.steepest == 0 && !range.any_yaw) || input.slider.sharp()) {
    return std::nullopt;
  }
  const auto found = [&](const TouchRange& poses) {
    Case own = input;
    own.motion = random_touches(poses, 1, options.seed);
    if (own.motion.waypoints.front().yaw) {
      settle_pose(own);
    }
    return mechanics::find_footprint(own, own.contact.friction, options.threads).footprint;
  };
  TouchRange upright = range;
  upright.steepest = upright.fastest_turn = 0;
  upright.any_yaw = false;
  mesh::Footprint footprint = found(range);
  const mesh::Footprint narrower = found(upright);
  for (std::size_t d = 0; d < 2; ++d) {
    footprint.resolved[d] = narrower.sharp(d) ? narrower.resolved[d] : narrower.rim[d];
  }
  return footprint;
}

/// Touches at the case's friction, or parts of them at some coefficients of a range.
std::vector<FullRun> training_runs(const Case& input, const TouchRange& range, const SkinData& data,
                                   const TrainingOptions& options) {
  const std::size_t count = options.friction ? runs_over_friction : 1;
  std::optional<mesh::Footprint> footprint = footprint_of_poses(input, range, options);
  std::vector<FullRun> runs;
  for (std::size_t i = 0; i < count; ++i) {
    Case own = input;
    if (count > 1) {
      own.contact.friction = std::lerp(data.lowest_friction, data.highest_friction,
                                       static_cast<double>(i) / static_cast<double>(count - 1));
    }
    // The first touch is in all of them.
    const std::size_t touches = 1 + (options.trajectories - 1 + count - 1) / count;
    runs.push_back(
        full_run(own, with_rows_behind_corners(random_touches(range, touches, options.seed + i)),
                 footprint, options));
    footprint = runs.back().contact.mesh.footprint();
  }
  return runs;
}

/// Refuses poses that a live skin cannot stand for.
void check_poses(const Case& input, const TrainingOptions& options) {
  const bool symmetry = input.skin.sides == SideCondition::symmetry;
  if (!(options.tilt >= 0 && options.tilt <= steepest_tilt)) {
    throw UserError(fmt::format("--tilt {:g}: must be from 0 to 5 degrees\n  = a tilt is carried "
                                "as a slope; give a steeper face as a height map",
                                options.tilt * 180 / std::numbers::pi));
  }
  if (!(options.turn >= 0 && options.turn <= fastest_spin)) {
    throw UserError(fmt::format("--spin {:g}: must be from 0 to {:g} degrees a second",
                                options.turn * 180 / std::numbers::pi,
                                fastest_spin * 180 / std::numbers::pi));
  }
  if ((options.tilt > 0 || options.turn > 0) && symmetry) {
    throw UserError("--tilt, --spin: between planes of symmetry a slider cannot roll or turn\n"
                    "  = set skin.sides = \"free\"");
  }
  if (options.turn > 0 && input.slider.sharp()) {
    throw UserError("--spin: sharp edges that turn do not follow the borders of the contact cells\n"
                    "  = round them by slider.edge_radius, or run the full model");
  }
}

/// Trains the model, whose errors are not measured yet.
TrainingRecord train_model(const Case& input, const TouchRange& range,
                           const TrainingOptions& options) {
  SkinData data;
  data.case_text = input.text;
  data.version = results::build_info::version;
  data.command = options.command;
  data.seed = options.seed;
  data.trajectories = options.trajectories;
  data.friction_law = input.contact.law;
  data.friction = data.lowest_friction = data.highest_friction = input.contact.friction;
  if (options.friction) {
    std::tie(data.lowest_friction, data.highest_friction) =
        std::pair((*options.friction)[0], (*options.friction)[1]);
  }
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
  set_pose(input, options, data);

  const std::vector<FullRun> runs = training_runs(input, range, data, options);
  const FullRun& run = runs.front();
  const auto model = std::make_shared<const mechanics::SkinModel>(
      run.input, run.contact.mesh.footprint(), range.box);
  const PlaceNodes places = place_nodes(run.input.skin, range.box);
  std::vector<std::string> channels{history::channel_name::shear};
  if (moves_water(input)) {
    channels.emplace_back(
        electrochemistry::driving_channel(run.input.coupling.law, run.history).name);
  }
  set_contact(runs, *model, places, data);
  set_charges(runs, data);
  data.channels = reduce_channels(
      run.input, data, model, places,
      contact_samples(data, range, range.any_yaw ? sampled_turned_states : sampled_states,
                      options.seed),
      options.threads, channels, options.progress);
  return {std::move(data), run.contact.mesh.footprint(), {}};
}

} // namespace

void check_trainable(const Case& input, const TrainingOptions& options) {
  if (input.strain.kind != StrainSourceKind::contact) {
    throw UserError("strain.source: a live skin needs a contact, and this case has none\n"
                    "  = set strain.source = \"contact\"");
  }
  if (!input.further_sliders.empty()) {
    throw UserError("slider: a live skin has one slider, and this case has a list of them\n"
                    "  = train each with --slider NUMBER, counted from 1, and step them together: "
                    "ionskin.live.Fingers in Python");
  }
  if (input.readout.circuit != circuits::circuits().front().name) {
    throw UserError("readout.circuit: a live skin supports only shorted electrodes\n"
                    "  = set readout.circuit = \"short\"");
  }
  if (input.readout.is_crossbar()) {
    throw UserError(
        "readout.taxels.wiring: a live skin supports only taxels at one potential above one bottom "
        "electrode, and this one is a crossbar\n"
        "  = remove readout.taxels.wiring: the currents of its columns and rows are sums "
        "of those of the taxels while all lines are at the ground");
  }
  if (input.readout.is_cut()) {
    throw UserError("readout.taxel_circuit: a live skin supports only taxels at one potential, and "
                    "here they have circuits of their own\n"
                    "  = set readout.taxel_circuit = \"shared\", and remove the circuits of single "
                    "taxels");
  }
  if (input.has_sheet_resistance()) {
    throw UserError("skin.layers[].sheet_resistance: a live skin supports only electrodes at one "
                    "potential each\n"
                    "  = remove it, or set readout.contact = \"everywhere\"");
  }
  if (options.friction) {
    const auto [low, high] = *options.friction;
    if (!(low >= 0 && low < high && high <= most_friction)) {
      throw UserError(
          fmt::format("--friction {} {}: must be two coefficients, the lower one first, "
                      "from 0 to {}",
                      low, high, most_friction));
    }
    if (input.contact.friction < low || input.contact.friction > high) {
      throw UserError(
          fmt::format("--friction {} {}: does not hold contact.friction = {}, with which "
                      "the skin begins\n  = widen the range, or set contact.friction",
                      low, high, input.contact.friction));
    }
  }
  if (laws::friction_law(input.contact.law).adheres) {
    throw UserError(fmt::format(
        "contact.law = \"{}\": a live skin does not support adhesion between slider and skin\n  "
        "= set contact.law = \"coulomb\"",
        input.contact.law));
  }
  if (input.motion.drive.given()) {
    throw UserError(
        "motion.drive: a live skin is given the position of the slider, and does not support a "
        "compliant drive\n  = remove motion.drive, and give each step the position of the slider");
  }
  if (input.slider.pose != shapes::Pose{} || input.slider.changing.any()) {
    throw UserError("slider.roll, slider.pitch, slider.yaw: a live skin is given the angles with "
                    "each step\n  = remove them, those of waypoints too, and train a tilt by "
                    "--tilt and a spin by --spin");
  }
  check_poses(input, options);
  touch_range(input);
}

SkinData train_skin(const Case& input, const TrainingOptions& options) {
  check_trainable(input, options);
  TouchRange range = touch_range(input);
  range.steepest = options.tilt;
  range.fastest_turn = options.turn;
  range.any_yaw = options.turn > 0 && !turns_into_itself(input.slider);
  TrainingRecord record;
  if (options.resume && std::filesystem::exists(options.record)) {
    record = read_record(options.record, options.identity);
  } else {
    TrainingOptions own = options;
    own.progress = part_of(options.progress, "training");
    record = train_model(input, range, own);
  }
  const auto keep = [&](const ComparedTouches& compared) {
    if (!options.record.empty()) {
      record.compared = compared;
      write_record(options.record, options.identity, record);
    }
  };
  TrainingOptions own = options;
  own.progress = part_of(options.progress, "validation");
  keep(record.compared);
  record.data.errors = stated_errors(errors_on_touches(
      record.data, input, range, options.validation, options.seed + validation_seed_shift,
      record.footprint, own, keep, record.compared));
  leave_out_no_moments(record.data);
  return std::move(record.data);
}

} // namespace ionskin::live
