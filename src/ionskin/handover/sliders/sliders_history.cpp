// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/sliders/sliders_history.hpp"

#include "ionskin/case/coupling.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/field_projection.hpp"
#include "ionskin/handover/repeated_cycles.hpp"
#include "ionskin/handover/sliders/fixed_grid.hpp"
#include "ionskin/handover/sliders/strain_transfer.hpp"
#include "ionskin/handover/strain_channels.hpp"
#include "ionskin/history/line_operators.hpp"
#include "ionskin/mechanics/output/force_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace ionskin::handover {
namespace {

/// Contact of one slider at an instant.
struct SliderInstant {
  StateCombination combination;
  std::array<double, 2> half_size{}; ///< of its footprint [m]
  MeshStrain own;                    ///< strain by the forces of only this slider
};

/// Sums the strains of all sliders at the points of one of them.
MeshStrain sum_at(const std::vector<SliderInstant>& touching, std::size_t here) {
  MeshStrain sum = touching[here].own;
  for (std::size_t other = 0; other < touching.size(); ++other) {
    if (other != here) {
      add_strain(touching[other].own, sum);
    }
  }
  return sum;
}

class SlidersHistory {
public:
  SlidersHistory(const std::vector<Case>& sliders,
                 const std::vector<mechanics::ContactSolution>& contacts)
      : sliders_(sliders), contacts_(contacts), rules_(channel_rules(sliders.front())),
        duration_(sliders.front().motion.cycle_duration()) {
    std::vector<const mesh::SkinMesh*> meshes;
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      timelines_.emplace_back(sliders[i], contacts[i]);
      meshes.push_back(&contacts[i].mesh);
    }
    core_ = fixed_core_grid(sliders, meshes);
    half_ = contacts.front().mesh.half_model();
    const bool water = moves_water(sliders.front());
    grid_ = {core_.x_edges, core_.y_edges, water ? history::halved(core_.z_lines) : core_.z_lines};
  }

  /// Grid of the whole core, also for a half model.
  history::StrainGrid whole_grid() const {
    history::StrainGrid whole = grid_;
    for (std::size_t i = grid_.y_edges.size() - 1; half_ && i-- > 0;) {
      whole.y_edges.push_back(sliders_.front().skin.width - grid_.y_edges[i]);
    }
    return whole;
  }
  const std::vector<ChannelRule>& rules() const { return rules_; }

  /// Sample instants of one cycle, ascending [s].
  std::vector<double> sample_times() const {
    std::vector<double> kept;
    for (const ContactTimeline& timeline : timelines_) {
      kept.insert(kept.end(), timeline.sample_times().begin(), timeline.sample_times().end());
    }
    std::ranges::sort(kept);
    std::vector<double> times{kept.front()};
    for (const double time : kept) {
      if (time - times.back() <= rounding * duration_) {
        continue;
      }
      const double from = times.back();
      const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(cells_gone(from, time))));
      for (std::size_t i = 1; i < parts; ++i) {
        times.push_back(from + (time - from) * static_cast<double>(i) / static_cast<double>(parts));
      }
      times.push_back(time);
    }
    return times;
  }

  /// Event instants of one cycle, ascending [s].
  std::vector<double> event_times() const {
    std::vector<double> events;
    for (const ContactTimeline& timeline : timelines_) {
      events.insert(events.end(), timeline.event_times().begin(), timeline.event_times().end());
    }
    std::ranges::sort(events);
    return events;
  }

  using Fields = std::vector<std::shared_ptr<const history::StrainField>>; // one per channel

  /// Calculates the fields at an instant of the cycle, or returns the stored fields of an instant
  /// with identical states and positions.
  const Fields& at(double time) {
    std::vector<SliderInstant> touching;
    Key key;
    for (std::size_t i = 0; i < timelines_.size(); ++i) {
      StateCombination combination = timelines_[i].at(time);
      if (combination.terms.empty()) {
        continue;
      }
      for (const auto& term : combination.terms) {
        key.first.emplace_back(term.state, term.weight);
      }
      key.second.push_back(combination.centre);
      const mesh::SkinMesh& mesh = contacts_[i].mesh;
      touching.push_back({std::move(combination), mesh.footprint().half_size, {}});
      SliderInstant& instant = touching.back();
      instant.own.lines = mesh.lines(instant.combination.centre);
      instant.own.core_z = core_lines(mesh, instant.own.lines);
    }
    const auto [found, is_new] = known_.try_emplace(std::move(key));
    if (is_new) {
      found->second = make_fields(touching, time);
    }
    return found->second;
  }

private:
  using Key = std::pair<std::vector<std::pair<const mechanics::ContactState*, double>>,
                        std::vector<std::array<double, 2>>>;
  static constexpr double rounding = 1e-12;

  /// Largest distance, in cells, by which a slider in contact moves between two instants.
  double cells_gone(double from, double to) const {
    const double width = fixed_cell_width(sliders_.front());
    double most = 0;
    for (const ContactTimeline& timeline : timelines_) {
      const StateCombination before = timeline.at(from), after = timeline.at(to);
      if (before.terms.empty() && after.terms.empty()) {
        continue;
      }
      const double way =
          std::hypot(after.centre[0] - before.centre[0], after.centre[1] - before.centre[1]);
      most = std::max(most, way / width);
    }
    return most;
  }

  Fields make_fields(std::vector<SliderInstant>& touching, double time) const {
    Fields fields;
    for (SliderInstant& one : touching) {
      one.own.strain = strain_at_points(one.combination);
      one.own.points = mechanics::core_strain(*one.combination.terms.front().state).points;
    }
    const std::vector<std::size_t> owners = owners_of_cells(touching);
    std::vector<history::StrainField> values(rules_.size(),
                                             history::StrainField(grid_.values(), 0.0));
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const MeshStrain sum = sum_at(touching, i);
      const FieldOperators along = onto_cells(sum, grid_, core_.z_lines);
      for (std::size_t channel = 0; channel < rules_.size(); ++channel) {
        const auto own = applied(along, rules_[channel].at_points(sum.strain), sum.points);
        for (std::size_t at = 0; at < own.size(); ++at) {
          if (owners[at % owners.size()] == i) {
            values[channel][at] = own[at];
          }
        }
      }
    }
    for (history::StrainField& field : values) {
      require_finite(field, sliders_.front(), time);
      if (half_) {
        field = reflected_field(field, grid_.z_nodes.size(), grid_.columns_y(), grid_.columns_x());
      }
      fields.push_back(std::make_shared<const history::StrainField>(std::move(field)));
    }
    return fields;
  }

  /// Index in `touching` of the slider that is nearest to each column of cells, [y][x].
  std::vector<std::size_t> owners_of_cells(const std::vector<SliderInstant>& touching) const {
    std::vector<std::size_t> owners;
    for (std::size_t j = 0; j < grid_.columns_y(); ++j) {
      for (std::size_t i = 0; i < grid_.columns_x(); ++i) {
        const std::array<double, 2> cell{0.5 * (grid_.x_edges[i] + grid_.x_edges[i + 1]),
                                         0.5 * (grid_.y_edges[j] + grid_.y_edges[j + 1])};
        double least = std::numeric_limits<double>::infinity();
        std::size_t owner = 0;
        for (std::size_t k = 0; k < touching.size(); ++k) {
          const double away = mechanics::distance(cell, {0, 0}, touching[k].combination.centre,
                                                  touching[k].half_size);
          if (away < least) {
            least = away;
            owner = k;
          }
        }
        owners.push_back(owner);
      }
    }
    return owners;
  }

  const std::vector<Case>& sliders_;
  const std::vector<mechanics::ContactSolution>& contacts_;
  std::vector<ChannelRule> rules_;
  double duration_ = 0;
  std::vector<ContactTimeline> timelines_;
  bool half_ = false;        ///< only y <= width / 2 is meshed
  CoreGrid core_;            ///< of the meshed part of the core
  history::StrainGrid grid_; ///< of the meshed part of the core
  std::map<Key, Fields> known_;
};

} // namespace

history::CoreHistory build_sliders_history(const std::vector<Case>& sliders,
                                           const std::vector<mechanics::ContactSolution>& contacts,
                                           const base::ProgressCallback& progress) {
  SlidersHistory made(sliders, contacts);
  const Case& input = sliders.front();
  history::CoreHistory history;
  history.frame = history::Frame::skin;
  history.measure = input.coupling.measure;
  history.length = input.skin.length;
  history.width = input.skin.width;
  history.grid = made.whole_grid();
  const std::vector<double> times = made.sample_times();
  std::vector<const SlidersHistory::Fields*> cycle;
  for (const double time : times) {
    cycle.push_back(&made.at(time));
    progress("strain history",
             static_cast<double>(cycle.size()) / static_cast<double>(times.size()));
  }
  for (const ChannelRule& rule : made.rules()) {
    history.add_channel(rule.name, *history::unit_of_channel(rule.name));
  }
  repeat_cycle(
      input.motion.cycles, times, made.event_times(),
      [&](std::size_t sample) {
        for (std::size_t channel = 0; channel < history.channels.size(); ++channel) {
          history.channels[channel].samples.push_back((*cycle[sample])[channel]);
        }
      },
      history);
  return history;
}

} // namespace ionskin::handover
