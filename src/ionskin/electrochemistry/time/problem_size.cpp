// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/problem_size.hpp"

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/time/step_control.hpp"
#include "ionskin/history/samples_per_slide.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ionskin::electrochemistry {
namespace {

/// Number of vectors of all unknowns that the solver holds: states, residuals and a usual Krylov
/// basis.
constexpr double vectors_per_unknown = 30.0;

/// Numbers of samples of a history: at an onset of sliding, and at a lift-off.
constexpr int onset_samples = 30, lift_off_samples = 20;
constexpr double onset_share = 1e-3; // of a slide

/// Ratio of neighbouring intervals between samples after an onset, until they are regular.
constexpr double sample_growth = 1.5;

/// Instants of one cycle after which the steps restart [s]: contact, loss of contact, and the begin
/// of every other leg in contact.
std::vector<double> cycle_events(const std::vector<MotionLeg>& legs) {
  std::vector<double> events;
  for (const MotionLeg& leg : legs) {
    if (!leg.touches()) {
      continue;
    }
    const ContactPart part = contact_part(leg);
    events.push_back(leg.begin + (leg.lands() ? part.begin : 0.0));
    if (leg.leaves()) {
      events.push_back(leg.begin + part.begin + part.duration);
    }
  }
  return events;
}

void add_uniform(double begin, double duration, int count, std::vector<double>& times) {
  for (int i = 1; i <= count; ++i) {
    times.push_back(begin + duration * i / count);
  }
}

/// Instants of one cycle at which the contact solution is likely to have samples [s].
std::vector<double> cycle_samples(const std::vector<MotionLeg>& legs, const Numerics& numerics) {
  const auto slide_samples = static_cast<int>(history::samples_per_slide(numerics));
  std::vector<double> samples;
  for (const MotionLeg& leg : legs) {
    const ContactPart part = contact_part(leg);
    if (leg.slides()) {
      add_uniform(leg.begin, onset_share * leg.duration, onset_samples, samples);
      add_uniform(leg.begin, leg.duration, slide_samples, samples);
      const double regular = leg.duration / slide_samples;
      double time = leg.begin + onset_share * leg.duration;
      for (double step = onset_share * leg.duration / onset_samples; step < regular;
           step *= sample_growth) {
        time += step;
        samples.push_back(time);
      }
    }
    if (leg.leaves()) {
      add_uniform(leg.begin + part.begin, part.duration, lift_off_samples, samples);
    }
    samples.push_back(leg.end());
  }
  return samples;
}

/// Makes a history with the extents of the skin, the events of the motion and likely samples, but
/// no shear.
history::CoreHistory outline(const Case& input) {
  history::CoreHistory history;
  const Skin& skin = input.skin;
  const bool uniform_y = covers_width(input);
  history.length = skin.length;
  history.width = skin.width;
  history.grid.x_edges = {0.0, 0.5 * skin.length, skin.length};
  history.grid.y_edges =
      uniform_y ? std::vector{0.0, skin.width} : std::vector{0.0, 0.5 * skin.width, skin.width};
  history.grid.z_nodes = {0.0, skin.core_thickness()};
  history.time = {0.0};
  const std::vector<MotionLeg> legs = joined_slides(motion_legs(input.motion, input.slider));
  for (int cycle = 0; cycle < input.motion.cycles; ++cycle) {
    const double start = cycle * legs.back().end();
    for (const double event : cycle_events(legs)) {
      history.event_time.push_back(start + event);
    }
    for (const double sample : cycle_samples(legs, input.numerics)) {
      history.time.push_back(start + sample);
    }
  }
  history.time.insert(history.time.end(), history.event_time.begin(), history.event_time.end());
  std::sort(history.time.begin(), history.time.end());
  history.time.erase(std::unique(history.time.begin(), history.time.end()), history.time.end());
  return history;
}

/// Time in which an edge of the slider crosses a column on a leg [s].
double crossing_time(const MotionLeg& leg, const Skin& skin, const ProblemSize& size) {
  const std::array<double, 2> width{skin.length / static_cast<double>(size.columns_x),
                                    skin.width / static_cast<double>(size.columns_y)};
  const double speed = leg.length() / leg.duration;
  double least = leg.duration;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double along = std::abs(leg.direction()[axis]) * speed;
    if (along * least > width[axis]) {
      least = width[axis] / along;
    }
  }
  return least;
}

/// Longest step that the tolerance is likely to allow while edges of the slider cross columns, in
/// each interval between neighbouring landings; infinite where none do [s].
std::vector<double> longest_steps(const Case& input, const StepLandings& landings,
                                  const StepRule& rule, const ProblemSize& size) {
  std::vector<double> longest(landings.time.size() - 1, std::numeric_limits<double>::infinity());
  if (input.strain.kind != StrainSourceKind::contact) {
    return longest;
  }
  const std::vector<MotionLeg> legs = joined_slides(motion_legs(input.motion, input.slider));
  for (std::size_t i = 0; i < longest.size(); ++i) {
    const double middle = 0.5 * (landings.time[i] + landings.time[i + 1]);
    const double since_begin = std::fmod(middle, legs.back().end());
    const auto leg =
        std::partition_point(legs.begin(), legs.end(), [since_begin](const MotionLeg& other) {
          return other.end() <= since_begin;
        });
    if (leg != legs.end() && leg->slides()) {
      longest[i] = crossing_step(rule, crossing_time(*leg, input.skin, size));
    }
  }
  return longest;
}

} // namespace

ProblemSize problem_size(const Case& input, const history::CoreHistory& history) {
  const TransportGrid grid = make_transport_grid(input, history);
  const DerivedScales scales = derive_scales(input.electrochemistry, history.core_thickness());
  ProblemSize size;
  size.columns_x = grid.x_edges.size() - 1;
  size.columns_y = grid.y_edges.size() - 1;
  // The model of thin layers has only a charge at each wall.
  size.levels = input.electrochemistry.ion_model == IonModel::thin_layers ? 1 : grid.z_nodes.size();
  size.unknowns = 2 * size.columns_x * size.columns_y * size.levels;
  const StepLandings landings =
      make_step_landings(history, input.output.fields,
                         scan_switches(input.readout, history.time.front(), history.time.back()));
  const StepRule rule = step_rule(input.numerics, input.readout, scales);
  size.steps = estimate_steps(landings, rule, relaxation_step(rule, scales),
                              longest_steps(input, landings, rule, size));
  size.memory = vectors_per_unknown * sizeof(double) * static_cast<double>(size.unknowns);
  return size;
}

ProblemSize estimate_problem_size(const Case& input) {
  return problem_size(input, input.strain.kind == StrainSourceKind::prescribed
                                 ? poroelasticity::prescribed_history(input)
                                 : outline(input));
}

} // namespace ionskin::electrochemistry
