// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/position_nodes.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/position/interpolation_error.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// A rectangle narrower than this part of the skin is a line, or a point: the compliance changes
/// there by less than any tolerance.
constexpr double narrow = 1e-5;

ExpectedNodes expected_along(const Case& input, const MotionBox& box, std::size_t axis) {
  const double size = axis == 0 ? input.skin.length : input.skin.width;
  if (box.high[axis] - box.low[axis] <= narrow * size) {
    return {1, 1};
  }
  return expected_nodes(input, axis, box.low[axis], box.high[axis]);
}

/// Uniform pressure with usual drag in given directions.
CellVector test_load(const SkinModel& model, const ForceDirections& directions) {
  constexpr double friction = 0.3;
  CellVector force(3 * model.cells.count());
  for (std::size_t cell = 0; cell < model.cells.count(); ++cell) {
    force[3 * cell] = model.cells.area[cell];
    force[3 * cell + 1] = directions[1] ? friction * model.cells.area[cell] : 0;
    force[3 * cell + 2] = directions[2] ? friction * model.cells.area[cell] : 0;
  }
  return force;
}

using Reflection = std::array<bool, 2>;

std::size_t mirror_index(const Reflection& reflect) {
  return (reflect[0] ? 1 : 0) + (reflect[1] ? 2 : 0);
}

/// Which mirror images of a position a rectangle may hold.
std::vector<Reflection> reflections_in(const Skin& skin, const MotionBox& box) {
  const Reflection low = canonical_position(skin, box.low).reflect,
                   high = canonical_position(skin, box.high).reflect;
  std::vector<Reflection> reflections;
  for (const Reflection& one :
       {low, Reflection{high[0], low[1]}, Reflection{low[0], high[1]}, high}) {
    if (std::ranges::find(reflections, one) == reflections.end()) {
      reflections.push_back(one);
    }
  }
  return reflections;
}

/// The strain under the test load of a position and of its mirror images, where the load is the
/// mirror image of what is applied here: its pressure is the same, its drag is not.
std::array<std::shared_ptr<const CoreStrain>, 4>
test_strains(const SkinModel& model, const CondensedPosition& condensed,
             const ForceDirections& directions, const std::vector<Reflection>& reflections) {
  std::vector<CellVector> loads;
  for (const Reflection& reflect : reflections) {
    loads.push_back(reflected(model.cells, test_load(model, directions), reflect));
  }
  const std::vector<CondensedPosition::Response> responses = condensed.respond(loads);
  std::array<std::shared_ptr<const CoreStrain>, 4> result;
  for (std::size_t i = 0; i < reflections.size(); ++i) {
    CoreStrain strain = condensed.strain(responses[i]);
    result[mirror_index(reflections[i])] = std::make_shared<const CoreStrain>(
        reflections[i] == Reflection{} ? std::move(strain)
                                       : mirrored(std::move(strain), reflections[i]));
  }
  return result;
}

/// A slider on a drive that halts swings on by its speed over the natural angular frequency.
void add_swing(const Case& input, MotionBox& box) {
  constexpr double most = 0.5; // of the room beside it
  const double seconds = input.motion.drive.natural_period() / (2 * std::numbers::pi);
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  const auto half_size = input.slider.flat_half_size();
  std::array<double, 2> fastest{};
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    for (std::size_t d = 0; d < 2 && leg.touches() && leg.duration > 0; ++d) {
      fastest[d] = std::max(fastest[d], std::abs(leg.to[d] - leg.from[d]) / leg.duration);
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    const double swing = fastest[d] * seconds;
    const double below = std::max(0.0, box.low[d] - half_size[d]),
                 above = std::max(0.0, skin[d] - half_size[d] - box.high[d]);
    box.low[d] -= std::min(swing, most * below);
    box.high[d] += std::min(swing, most * above);
  }
}

} // namespace

std::optional<MotionBox> contact_box(const Case& input) {
  std::optional<MotionBox> box;
  const auto include = [&](const std::array<double, 2>& place) {
    if (!box) {
      box = MotionBox{place, place};
    }
    for (std::size_t d = 0; d < 2; ++d) {
      box->low[d] = std::min(box->low[d], place[d]);
      box->high[d] = std::max(box->high[d], place[d]);
    }
  };
  const bool adheres = laws::friction_law(input.contact.law).adheres;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (leg.touches()) {
      // Where a height turns into a force the whole leg may touch.
      const ContactPart part = contact_part(leg);
      include(adheres ? leg.from : part.from);
      include(adheres ? leg.to : part.to);
    }
  }
  if (box && input.numerics.shared.given()) {
    return meshed_box(input);
  }
  if (box && input.motion.drive.given()) {
    add_swing(input, *box);
  }
  return box;
}

std::array<std::size_t, 2> expected_counts(const Case& input, const MotionBox& box) {
  return {expected_along(input, box, 0).all, expected_along(input, box, 1).all};
}

NodeLines node_lines(const Case& input, const MotionBox& box,
                     const std::array<std::size_t, 2>& counts) {
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  NodeLines lines;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double low = box.low[axis], high = box.high[axis];
    lines.coordinate[axis] = end_coordinate(low, high, skin[axis]);
    lines.in_pairs[axis] = mirrored_places(low, high, skin[axis]);
    lines.at[axis] = counts[axis] == 1 ? std::vector{low + (high - low) / 2}
                                       : interpolation_nodes(lines.coordinate[axis], low, high,
                                                             counts[axis], lines.in_pairs[axis]);
  }
  return lines;
}

std::size_t expected_places(const Case& input, const MotionBox& box) {
  const NodeLines lines = node_lines(input, box, expected_counts(input, box));
  std::vector<std::array<double, 2>> places;
  for (const double y : lines.at[1]) {
    for (const double x : lines.at[0]) {
      const auto centre = canonical_position(input.skin, {x, y}).centre;
      if (std::ranges::none_of(
              places, [&](const auto& known) { return same_place(input.skin, known, centre); })) {
        places.push_back(centre);
      }
    }
  }
  return places.size();
}

bool loads_across_at_ends(const Case& input, const MotionBox& box) {
  constexpr double rounding = 1e-9;
  const auto counts = expected_counts(input, box);
  if ((counts[0] > 1) == (counts[1] > 1) || input.numerics.shared.given() ||
      input.motion.drive.given()) {
    return false;
  }
  const std::size_t axis = counts[0] > 1 ? 0 : 1;
  const auto at_end = [&](const std::array<double, 2>& place) {
    return std::min(place[axis] - box.low[axis], box.high[axis] - place[axis]) <=
           rounding * (box.high[axis] - box.low[axis]);
  };
  const std::vector<MotionLeg> legs = motion_legs(input.motion, input.slider);
  const bool held = std::ranges::all_of(
      legs, [](const MotionLeg& leg) { return !leg.slides() || leg.from_level == leg.to_level; });
  return held && std::ranges::all_of(joined_slides(legs), [&](const MotionLeg& leg) {
           return !leg.touches() || (at_end(leg.from) && at_end(leg.to));
         });
}

double node_tolerance(const Case& input, const MotionBox& box) {
  const auto counts = expected_counts(input, box);
  return interpolation_tolerance(input.numerics.preset, counts[0] > 1 && counts[1] > 1);
}

PositionNodes::PositionNodes(const Case& input, std::shared_ptr<const SkinModel> model,
                             const MotionBox& box, const NodeOptions& options,
                             parallel::SharedProgress& progress)
    : model_(std::move(model)), skin_(input.skin), options_(options),
      expected_places_(options.positions > 0 ? options.positions : expected_places(input, box)),
      reflections_(reflections_in(input.skin, box)), tolerance_(node_tolerance(input, box)) {
  std::array<std::size_t, 2> counts{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const ExpectedNodes expected = expected_along(input, box, axis);
    counts[axis] = expected.all > 1 && options.count > 0 ? options.count : expected.first;
  }
  for (bool settled = false; !settled;) {
    condense(node_lines(input, box, counts), progress);
    const auto wanted = wanted_counts(tolerance_);
    settled = options.count > 0 || wanted == counts;
    counts = wanted;
  }
  std::vector<DenseMatrix> compliances;
  for (const Node& node : nodes_) {
    compliances.push_back(reflected_compliance(node));
  }
  compliance_ = std::make_unique<const ComplianceMap>(lines_, std::move(compliances));
  for (Place& place : places_) {
    place.compliance = {};
    place.test = {};
  }
}

PositionNodes::Condensed PositionNodes::condensed_at(std::size_t index,
                                                     parallel::SpareThreads& spare) const {
  const Place& place = places_[index];
  return place.condensed ? place.condensed
                         : std::make_shared<const CondensedPosition>(
                               *model_, place.centre,
                               PositionUse{options_.cache, place.forces, expected_places_,
                                           options_.threads, &spare});
}

ForceDirections PositionNodes::along_line() const {
  ForceDirections directions{true, true, true};
  if (options_.across_at_ends) {
    directions[lines_.at[0].size() > 1 ? 2 : 1] = false;
  }
  return directions;
}

void PositionNodes::condense(const NodeLines& lines, parallel::SharedProgress& progress) {
  lines_ = lines;
  nodes_.clear();
  const std::size_t known = places_.size();
  for (const double y : lines.at[1]) {
    for (const double x : lines.at[0]) {
      const CanonicalPosition position = canonical_position(skin_, {x, y});
      const auto same = std::ranges::find_if(places_, [&](const Place& place) {
        return same_place(skin_, place.centre, position.centre);
      });
      nodes_.push_back({position, static_cast<std::size_t>(same - places_.begin())});
      if (same == places_.end()) {
        places_.push_back({position.centre, along_line(), {}, nullptr, {}});
      }
    }
  }
  places_[nodes_.front().condensed].forces =
      places_[nodes_.back().condensed].forces = {true, true, true};
  ForceDirections test_directions = along_line();
  test_directions[2] = test_directions[2] && !model_->mesh.half_model();
  // The first place to begin factorises the part under the slider for all of them. Those of the
  // ends respond in more directions: they come last.
  std::vector<std::size_t> order(places_.size() - known);
  std::iota(order.begin(), order.end(), known);
  std::ranges::stable_partition(order, [&](std::size_t i) {
    return places_[i].forces != ForceDirections{true, true, true};
  });
  progress.add_units(order.size());
  parallel::SpareThreads spare;
  parallel::run_tasks(
      order.size(), options_.threads,
      [&](std::size_t i) {
        base::check_interrupt();
        Place& place = places_[order[i]];
        const Condensed condensed = condensed_at(order[i], spare);
        place.compliance = contact_compliance(*model_, *condensed);
        place.test = test_strains(*model_, *condensed, test_directions, reflections_);
        place.condensed = condensed->holds_factor() ? nullptr : condensed;
        progress.finish_unit();
      },
      &spare);
}

std::array<std::size_t, 2> PositionNodes::wanted_counts(double tolerance) {
  const std::array<std::size_t, 2> counts{lines_.at[0].size(), lines_.at[1].size()};
  std::array<std::size_t, 2> wanted = counts;
  error_ = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t line = 0; line < counts[1 - axis] && counts[axis] > 1; ++line) {
      std::vector<NodeStrain> along;
      for (std::size_t i = 0; i < counts[axis]; ++i) {
        const Node& node = nodes_[axis == 0 ? i + counts[0] * line : line + counts[0] * i];
        along.push_back({lines_.coordinate[axis].at(lines_.at[axis][i]),
                         places_[node.condensed].test[mirror_index(node.position.reflect)]});
      }
      const InterpolationError error = interpolation_error(along);
      error_ = base::larger(error_, error.estimate);
      wanted[axis] = std::max(
          wanted[axis], wanted_node_count(counts[axis], error, tolerance, lines_.in_pairs[axis]));
    }
  }
  return wanted;
}

DenseMatrix PositionNodes::reflected_compliance(const Node& node) const {
  const DenseMatrix& canonical = places_[node.condensed].compliance;
  DenseMatrix rows(canonical.rows, canonical.columns), result = rows;
  CellVector column(static_cast<std::size_t>(canonical.rows));
  const auto reflect_columns = [&](const DenseMatrix& from, DenseMatrix& to) {
    for (int j = 0; j < from.columns; ++j) {
      std::copy(from.column(j), from.column(j) + from.rows, column.begin());
      const CellVector turned = reflected(model_->cells, column, node.position.reflect);
      for (int i = 0; i < from.rows; ++i) {
        to(j, i) = turned[static_cast<std::size_t>(i)]; // transposed: twice is the matrix again
      }
    }
  };
  reflect_columns(canonical, rows);
  reflect_columns(rows, result);
  return result;
}

} // namespace ionskin::mechanics
