// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/handover.hpp"

#include "ionskin/handover/field_projection.hpp"
#include "ionskin/handover/repeated_cycles.hpp"
#include "ionskin/handover/strain_channels.hpp"
#include "ionskin/handover/strain_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ionskin::handover {
namespace {

/// Key of a field: the states with their weights, and the position of the slider. While the slider
/// is detached there are no states, and the position is left out.
using FieldKey = std::pair<std::vector<std::pair<const mechanics::ContactState*, double>>,
                           std::array<double, 2>>;

FieldKey field_key(const StateCombination& combination) {
  FieldKey key;
  for (const auto& term : combination.terms) {
    key.first.emplace_back(term.state, term.weight);
  }
  if (!combination.terms.empty()) {
    key.second = combination.centre;
  }
  return key;
}

/// Box of the motion, extended by the positions to which a drive let the slider move.
MotionBox box_of_path(const Case& input, const mechanics::ContactSolution& contact) {
  constexpr double negligible = 1e-9; // share of the size of the skin
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  MotionBox box = motion_box(input.motion, input.slider);
  for (const mechanics::SteppedInstant& instant : contact.stepped) {
    for (std::size_t d = 0; d < 2; ++d) {
      if (instant.centre[d] < box.low[d] - negligible * skin[d]) {
        box.low[d] = instant.centre[d];
      }
      if (instant.centre[d] > box.high[d] + negligible * skin[d]) {
        box.high[d] = instant.centre[d];
      }
    }
  }
  return box;
}

} // namespace

history::CoreHistory build_strain_history(const Case& input,
                                          const mechanics::ContactSolution& contact,
                                          const base::ProgressCallback& progress) {
  const ContactTimeline timeline(input, contact);
  const mesh::SkinMesh& mesh = contact.mesh;
  const MotionBox box = box_of_path(input, contact);
  const FieldProjection projection(input, mesh, box);

  history::CoreHistory history;
  history.frame = history::Frame::slider;
  history.measure = input.coupling.measure;
  history.length = input.skin.length;
  history.width = input.skin.width;
  history.grid = projection.grid();
  const auto field_at = [&](const ChannelRule& rule, const StateCombination& combination) {
    return projection.at(rule.at_points(strain_at_points(combination)),
                         core_strain(*combination.terms.front().state).points, combination.centre);
  };

  const std::vector<ChannelRule> rules = channel_rules(input);
  using Fields = std::vector<std::shared_ptr<const history::StrainField>>; // one per channel
  const auto nothing = std::make_shared<const history::StrainField>(
      history::StrainField(history.grid.values(), 0.0));
  std::map<FieldKey, Fields> known;
  std::vector<const Fields*> cycle_fields;
  std::vector<std::array<double, 2>> cycle_centres;
  for (std::size_t i = 0; i < timeline.sample_times().size(); ++i) {
    const StateCombination combination = timeline.at_sample(i);
    Fields& fields = known[field_key(combination)];
    for (std::size_t channel = fields.size(); channel < rules.size(); ++channel) {
      fields.push_back(combination.terms.empty() ? nothing
                                                 : std::make_shared<const history::StrainField>(
                                                       field_at(rules[channel], combination)));
      require_finite(*fields.back(), input, timeline.sample_times()[i]);
    }
    progress("strain history",
             static_cast<double>(i + 1) / static_cast<double>(timeline.sample_times().size()));
    cycle_centres.push_back(combination.centre);
    cycle_fields.push_back(&fields);
  }
  for (const ChannelRule& rule : rules) {
    history.add_channel(rule.name, *history::unit_of_channel(rule.name));
  }
  const double middle = 0.5 * input.skin.width;
  const bool off_centre = box.low[1] != middle || box.high[1] != middle;
  repeat_cycle(
      input.motion.cycles, timeline.sample_times(), timeline.event_times(),
      [&](std::size_t sample) {
        history.slider_x.push_back(cycle_centres[sample][0]);
        if (off_centre) {
          history.slider_y.push_back(cycle_centres[sample][1]);
        }
        for (std::size_t channel = 0; channel < rules.size(); ++channel) {
          history.channels[channel].samples.push_back((*cycle_fields[sample])[channel]);
        }
      },
      history);
  return history;
}

double mechanics_shear_integral(const Case& input, const mesh::SkinMesh& mesh,
                                const StateCombination& combination) {
  if (combination.terms.empty()) {
    return 0.0;
  }
  const auto lines = mesh.lines(combination.centre);
  const auto z_lines = core_lines(mesh, lines);
  const auto shear = channel_rules(input).front().at_points(strain_at_points(combination));
  const auto points = core_strain(*combination.terms.front().state).points;
  const auto weight = [](const std::vector<double>& line, std::size_t point) {
    return 0.5 * (line[point / 2 + 1] - line[point / 2]);
  };
  double integral = 0;
  for (std::size_t k = 0; k < points[2]; ++k) {
    for (std::size_t j = 0; j < points[1]; ++j) {
      double row = 0;
      for (std::size_t i = 0; i < points[0]; ++i) {
        row += weight(lines.x, i) * shear[(k * points[1] + j) * points[0] + i];
      }
      integral += weight(z_lines, k) * weight(lines.y, j) * row;
    }
  }
  return mesh.half_model() ? 2 * integral : integral;
}

} // namespace ionskin::handover
