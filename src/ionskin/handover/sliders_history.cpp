// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/sliders_history.hpp"

#include "ionskin/case/coupling.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/field_projection.hpp"
#include "ionskin/handover/fixed_grid.hpp"
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

/// Operators along z, y and x of a field [z][y][x].
using Operators = std::array<history::LineOperator, 3>;

/// @param points of the field along x, y and z
std::vector<double> apply(const Operators& along, std::vector<double> field,
                          const std::array<std::size_t, 3>& points) {
  std::vector<double> next;
  history::apply_along(along[0], 1, points[1] * points[0], field, next);
  history::apply_along(along[1], along[0].rows(), points[0], next, field);
  history::apply_along(along[2], along[0].rows() * along[1].rows(), 1, field, next);
  return next;
}

/// Both Gauss points of each interval.
std::vector<double> gauss_points(const std::vector<double>& lines) {
  const double offset = 0.5 / std::sqrt(3.0);
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double length = lines[i + 1] - lines[i], middle = 0.5 * (lines[i] + lines[i + 1]);
    places.push_back(middle - offset * length);
    places.push_back(middle + offset * length);
  }
  return places;
}

/// One slider at an instant.
struct SliderInstant {
  StateCombination combination;
  std::array<double, 2> half_size{}; ///< of its footprint [m]
  mesh::MeshLines lines;
  std::vector<double> core_z; ///< lines through the core, from its bottom [m]
  std::array<std::size_t, 3> points{};
  PointStrain strain; ///< of its forces alone, at the points of its own mesh
};

/// Each value is its own.
history::LineOperator identity(std::size_t count) {
  history::LineOperator same{count, {}, std::vector(count, std::vector{1.0})};
  for (std::size_t i = 0; i < count; ++i) {
    same.first.push_back(i);
  }
  return same;
}

/// Carries a strain from the points of one mesh to those of another; along x and y these are means
/// over halves of cells, which keep their integral.
Operators between(const SliderInstant& from, const SliderInstant& to) {
  const auto along = [](const std::vector<double>& lines, const std::vector<double>& target) {
    return history::half_means_averages(lines, history::halved(target));
  };
  return {from.core_z == to.core_z ? identity(2 * (from.core_z.size() - 1))
                                   : history::compose(history::linear_interpolation(
                                                          from.core_z, gauss_points(to.core_z)),
                                                      history::linear_projection(from.core_z)),
          along(from.lines.y, to.lines.y), along(from.lines.x, to.lines.x)};
}

/// Strain of all sliders at the points of one of them.
PointStrain sum_at(const std::vector<SliderInstant>& touching, std::size_t here) {
  PointStrain sum = touching[here].strain;
  for (std::size_t other = 0; other < touching.size(); ++other) {
    if (other == here) {
      continue;
    }
    const Operators along = between(touching[other], touching[here]);
    for (std::size_t c = 0; c < sum.size(); ++c) {
      if (touching[other].strain[c].empty()) {
        continue;
      }
      const auto carried = apply(along, touching[other].strain[c], touching[other].points);
      for (std::size_t i = 0; i < sum[c].size(); ++i) {
        sum[c][i] += carried[i];
      }
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

  /// Grid of the whole core.
  history::StrainGrid whole_grid() const {
    history::StrainGrid whole = grid_;
    for (std::size_t i = grid_.y_edges.size() - 1; half_ && i-- > 0;) {
      whole.y_edges.push_back(sliders_.front().skin.width - grid_.y_edges[i]);
    }
    return whole;
  }
  const std::vector<ChannelRule>& rules() const { return rules_; }

  /// Instants of one cycle [s].
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

  /// Events of one cycle [s].
  std::vector<double> event_times() const {
    std::vector<double> events;
    for (const ContactTimeline& timeline : timelines_) {
      events.insert(events.end(), timeline.event_times().begin(), timeline.event_times().end());
    }
    std::ranges::sort(events);
    return events;
  }

  using Fields = std::vector<std::shared_ptr<const history::StrainField>>; // one per channel

  /// Fields at an instant of the cycle; those of instants with the same states are the same.
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
      touching.push_back(
          {std::move(combination), contacts_[i].mesh.footprint().half_size, {}, {}, {}, {}});
      touching.back().lines = contacts_[i].mesh.lines(touching.back().combination.centre);
      touching.back().core_z = core_lines(contacts_[i].mesh, touching.back().lines);
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

  /// Cells over which the fastest slider that touches goes between two instants.
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
      one.strain = strain_at_points(one.combination);
      one.points = mechanics::core_strain(*one.combination.terms.front().state).points;
    }
    const std::vector<std::size_t> owners = owners_of_cells(touching);
    std::vector<history::StrainField> values(rules_.size(),
                                             history::StrainField(grid_.values(), 0.0));
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const PointStrain sum = sum_at(touching, i);
      const Operators along = onto_grid(touching[i]);
      for (std::size_t channel = 0; channel < rules_.size(); ++channel) {
        const auto own = apply(along, rules_[channel].at_points(sum), touching[i].points);
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

  /// Means over the cells of the grid, linear through the thickness.
  Operators onto_grid(const SliderInstant& from) const {
    const bool halved = grid_.z_nodes.size() > core_.z_lines.size();
    history::LineOperator along_z =
        halved ? history::halved_projection(from.core_z) : history::linear_projection(from.core_z);
    if (from.core_z != core_.z_lines) { // the mesh of another slider
      along_z =
          history::compose(history::linear_interpolation(
                               halved ? history::halved(from.core_z) : from.core_z, grid_.z_nodes),
                           along_z);
    }
    return {std::move(along_z), history::half_means_averages(from.lines.y, grid_.y_edges),
            history::half_means_averages(from.lines.x, grid_.x_edges)};
  }

  /// The slider that is nearest to each column of cells, [y][x].
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
  bool half_ = false;        ///< y <= width / 2 is meshed alone
  CoreGrid core_;            ///< of what is meshed
  history::StrainGrid grid_; ///< likewise
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
  const double duration = times.back();
  for (int count = 0; count < input.motion.cycles; ++count) {
    const double offset = count * duration;
    for (std::size_t i = count == 0 ? 0 : 1; i < times.size(); ++i) {
      history.time.push_back(offset + times[i]);
      for (std::size_t channel = 0; channel < history.channels.size(); ++channel) {
        history.channels[channel].samples.push_back((*cycle[i])[channel]);
      }
    }
    for (const double event : made.event_times()) {
      // Event times are sample times, up to coinciding ones: take the sample itself.
      const auto sample = std::ranges::lower_bound(history.time, offset + event - 2e-12 * duration);
      if (history.event_time.empty() || history.event_time.back() < *sample) {
        history.event_time.push_back(*sample);
      }
    }
  }
  return history;
}

} // namespace ionskin::handover
