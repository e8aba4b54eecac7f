// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include "ionskin/mechanics/surface/adhesion_energy.hpp"
#include "ionskin/mechanics/surface/adhesive_force.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

bool is_loaded(const CellVector& force) {
  return std::any_of(force.begin(), force.end(), [](double value) { return value != 0; });
}

/// Largest relative change of the normal forces, as sums of magnitudes, in a step of an adhesive
/// contact without a jump [1].
constexpr double most_changed = 0.5;

/// Relative change of the cells' normal forces [1]: sum of the magnitudes of the changes, over the
/// larger sum of the magnitudes before and after.
double change_of_load(const CellVector& before, const CellVector& after) {
  double change = 0, first = 0, last = 0;
  for (std::size_t at = 0; at < before.size(); at += 3) {
    change += std::abs(after[at] - before[at]);
    first += std::abs(before[at]);
    last += std::abs(after[at]);
  }
  return change > 0 ? change / std::max(first, last) : 0.0;
}

double total_force(const CellVector& force, std::size_t component) {
  double sum = 0;
  for (std::size_t at = component; at < force.size(); at += 3) {
    sum += force[at];
  }
  return sum;
}

/// Contact problem with a slider that yields: to the cells, the slider is one more compliance,
/// equal between any two cells, docs/model.md (39).
ContactProblem yielding_problem(const ContactProblem& problem,
                                const std::array<double, 2>& compliance) {
  ContactProblem yielding = problem;
  yielding.common = compliance;
  const auto size = static_cast<int>(yielding.compliance.rows());
  for (int column = 0; column < size; ++column) {
    const int component = column % 3;
    if (component == 0) {
      continue;
    }
    double* values = yielding.compliance.col(column).data();
    for (int row = component; row < size; row += 3) {
      values[row] += compliance[static_cast<std::size_t>(component) - 1];
    }
  }
  return yielding;
}

} // namespace

SlidingContact::SlidingContact(ComplianceAt compliance, std::vector<double> area,
                               std::vector<double> gap, const laws::Friction& friction,
                               std::shared_ptr<const TurningUnderside> turning)
    : compliance_(std::move(compliance)), problem_{{}, std::move(area), std::move(gap), friction},
      turning_(std::move(turning)) {
  if (turning_) {
    pose_ = turning_->first();
  }
  state_.force.assign(3 * problem_.area.size(), 0.0);
  state_.surface = state_.force;
  state_.slip.assign(problem_.area.size(), 0.0);
}

bool SlidingContact::in_contact() const {
  return is_loaded(state_.force);
}

double SlidingContact::energy() const {
  return in_contact() ? potential_energy(problem_, state_) : 0.0;
}

bool SlidingContact::sticks() const {
  return stick_fraction(problem_, state_.force) > 0;
}

/// Lagged slip speed of each cell after `time_step` [s], which relaxes towards the slip speed of
/// the last step [m/s].
std::vector<double> SlidingContact::followed(const std::vector<double>& speed,
                                             double time_step) const {
  const double lag = problem_.friction.lag, last = state_.step.time_step;
  if (lag == 0 || last == 0) {
    return speed;
  }
  std::vector<double> result = speed;
  result.resize(problem_.area.size(), 0.0);
  const double left = std::exp(-time_step / lag);
  for (std::size_t cell = 0; cell < result.size(); ++cell) {
    const bool touches = state_.force[3 * cell] > 0;
    result[cell] = touches ? left * result[cell] + (1 - left) * state_.slip[cell] / last : 0.0;
  }
  return result;
}

/// Divides the slip of the present state into an elastic and a lost part, and adds the energy that
/// friction created in the step.
void SlidingContact::divide_slip() {
  created_energy_ += friction_energy(problem_, state_).created;
  if (problem_.friction.elastic_slip == 0) {
    return;
  }
  elastic_slip_.resize(problem_.area.size());
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    const laws::SlipDivision division = problem_.divided_slip(
        cell, state_.force[3 * at], slip_increment(state_.step, state_.surface, cell), state_.step);
    elastic_slip_[at] = division.elastic;
    state_.slip[at] = division.lost;
  }
}

void SlidingContact::detach(const SliderStep& step) {
  elastic_slip_.clear();
  problem_.lagged_speed.clear();
  remembered_speed_.clear();
  std::fill(state_.force.begin(), state_.force.end(), 0.0);
  state_.surface = problem_.by_others;
  state_.surface.resize(state_.force.size(), 0.0);
  std::fill(state_.slip.begin(), state_.slip.end(), 0.0);
  const double first_touch = problem_.least_free_gap();
  state_.indentation =
      step.load.kind == LoadKind::force ? first_touch : std::max(0.0, step.load.value);
  state_.step = step;
  state_.iterations = 0;
}

void SlidingContact::condense_at(const std::array<double, 2>& place) {
  if (condensed_at_ != place) {
    compliance_(place, problem_);
    condensed_at_ = place;
  }
}

bool SlidingContact::reaches(const SliderLoad& load) const {
  const laws::CohesiveZone& adhesion = problem_.friction.adhesion;
  if (adhesion.pulls() && in_contact()) {
    return true; // adhesion may hold the slider at any height
  }
  const double least =
      load.kind == LoadKind::force ? 0 : problem_.least_free_gap() - adhesion.range;
  return !(load.value <= least); // NaN passes, and the solver refuses it
}

SurfaceState SlidingContact::solve_adhesive(const ContactProblem& problem, const SliderStep& step) {
  Iterate iterate{state_.force, state_.indentation};
  if (in_contact() && newton_.solve(problem, step, iterate)) {
    // Newton's method may end at a solution that a slow motion would not reach.
    if (change_of_load(state_.force, iterate.force) <= most_changed) {
      return surface_state(problem, step, std::move(iterate.force), iterate.indentation,
                           newton_.iterations());
    }
  }
  ++fallbacks_;
  newton_.forget();
  may_have_jumped_ = true;
  const AdhesiveStart start = in_contact() ? start_from(problem, state_) : far_apart(problem);
  return step.load.kind == LoadKind::force ? adhesive_contact_at_force(problem, step, start)
                                           : relaxed_contact(problem, step, start);
}

SurfaceState SlidingContact::solve(const ContactProblem& problem, const SliderStep& step) {
  may_have_jumped_ = false;
  if (problem.friction.adhesion.pulls()) {
    return solve_adhesive(problem, step);
  }
  Iterate iterate{state_.force, state_.indentation};
  if (newton_.solve(problem, step, iterate)) {
    return surface_state(problem, step, std::move(iterate.force), iterate.indentation,
                         newton_.iterations());
  }
  ++fallbacks_;
  newton_.forget();
  return solve_contact_step(problem, step, CellVector(state_.force.size(), 0.0));
}

const SurfaceState& SlidingContact::step(double time_step, const std::array<double, 2>& place,
                                         const SliderLoad& load, const shapes::Pose& pose) {
  return move(time_step, {place, place, {}}, load, turning_ ? std::optional(pose) : std::nullopt);
}

const SurfaceState& SlidingContact::step_yielding(double time_step, const SliderGuide& guide,
                                                  const SliderLoad& load) {
  return move(time_step, guide, load, std::nullopt);
}

std::shared_ptr<const std::vector<std::array<double, 3>>> SlidingContact::turned() const {
  return pose_ ? std::make_shared<const std::vector<std::array<double, 3>>>(
                     turning_->place(*pose_, problem_.gap))
               : nullptr;
}

/// Solves a step. Where there is no solution, throws and leaves the contact as it was.
/// @param pose at the end; empty if the pose does not change
const SurfaceState& SlidingContact::move(double time_step, const SliderGuide& guide,
                                         const SliderLoad& load,
                                         const std::optional<shapes::Pose>& pose) {
  const std::array<double, 2> from = place_.value_or(guide.expected);
  SliderStep step{load,
                  {guide.place[0] - from[0], guide.place[1] - from[1]},
                  time_step,
                  state_.surface,
                  elastic_slip_};
  std::vector<double> gap_before;
  if (pose && pose != pose_) {
    gap_before = problem_.gap;
    problem_.gap = turning_->gap(*pose);
    if (pose_ && pose->yaw != pose_->yaw) {
      step.turn = turning_->turn(pose->yaw - pose_->yaw);
    }
  }
  const bool yields = guide.compliance != std::array<double, 2>{};
  condense_at(guide.expected);
  CellVector others_before = problem_.by_others;
  if (others_) {
    problem_.by_others = others_(end_of_step_, guide.expected);
  }
  may_have_jumped_ = false;
  if (!reaches(load)) {
    detach(step);
    place_ = guide.place;
    pose_ = pose;
    return state_;
  }
  std::vector<double> remembered = followed(remembered_speed_, state_.step.time_step);
  std::vector<double> lagged = yields ? followed(remembered, time_step) : remembered;
  problem_.lagged_speed.swap(lagged);
  std::array<double, 2> place = guide.place;
  try {
    if (yields) {
      const ContactProblem yielding = yielding_problem(problem_, guide.compliance);
      SurfaceState found = solve(yielding, step);
      for (std::size_t c = 0; c < 2; ++c) {
        // Position under the forces before they were settled: sticking cells must not slip because
        // slipping cells were settled on their limits.
        place[c] -=
            guide.compliance[c] * (total_force(found.force, c + 1) - newton_.settled_by()[c]);
        step.travel[c] = place[c] - from[c];
      }
      state_ = surface_state(problem_, step, std::move(found.force), found.indentation,
                             found.iterations);
    } else {
      state_ = solve(problem_, step);
    }
    divide_slip();
    if (!in_contact() && problem_.friction.adhesion.pulls()) {
      detach(step);
      place_ = guide.place;
      return state_;
    }
  } catch (...) {
    problem_.lagged_speed.swap(lagged);
    problem_.by_others = std::move(others_before);
    if (!gap_before.empty()) {
      problem_.gap = std::move(gap_before);
    }
    if (place_) {
      condense_at(*place_);
    }
    throw;
  }
  remembered_speed_ = std::move(remembered);
  place_ = place;
  pose_ = pose;
  return state_;
}

void SlidingContact::go_back(Moment moment) {
  state_ = std::move(moment.state);
  elastic_slip_ = std::move(moment.elastic_slip);
  remembered_speed_ = std::move(moment.remembered_speed);
  place_ = moment.place;
  created_energy_ = moment.created_energy;
}

SlidingContact::OnsetDistance SlidingContact::onset_distance(const std::array<double, 2>& direction,
                                                             bool half_model, double slip,
                                                             double time_step) const {
  CellVector sliding(state_.force.size(), 0.0);
  for (int cell = 0; cell < problem_.cells(); ++cell) {
    const std::size_t at = 3 * static_cast<std::size_t>(cell);
    const double limit = problem_.friction_limit(cell, state_.force[at], slip, time_step);
    const auto traction = laws::sliding_traction(problem_.friction, limit, direction);
    sliding[at] = state_.force[at];
    sliding[at + 1] = traction[0];
    sliding[at + 2] = traction[1];
  }
  const CellVector surface = problem_.surface_displacement(sliding);
  std::array<double, 2> left{}, whole{};
  for (std::size_t at = 0; at < surface.size(); at += 3) {
    for (std::size_t c = 0; c < (half_model ? 1u : 2u); ++c) {
      left[c] += surface[at + 1 + c] - state_.surface[at + 1 + c];
      whole[c] +=
          surface[at + 1 + c] - (problem_.by_others.empty() ? 0.0 : problem_.by_others[at + 1 + c]);
    }
  }
  const auto cells = static_cast<double>(problem_.area.size());
  const double elastic = std::min(slip, problem_.friction.elastic_slip);
  return {std::hypot(left[0], left[1]) / cells + elastic,
          std::hypot(whole[0], whole[1]) / cells + elastic};
}

} // namespace ionskin::mechanics
