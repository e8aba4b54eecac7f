// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/path_thinning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr std::size_t most_waiting = 64; ///< largest number of instants between stored ones
/// Allowance for rounding [1]: steps are often exactly as long as a limit, or as a fraction of it.
constexpr double beyond_rounding = 1 + 1e-6;
/// Smallest gap at which a cell counts as beyond the underside [m].
constexpr double far_beyond = 0.1;

double component(const CellVector& force, std::size_t at) {
  return force.empty() ? 0.0 : force[at];
}

double way(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  return std::hypot(to[0] - from[0], to[1] - from[1]);
}

} // namespace

PathThinning::PathThinning(const ThinningTolerance& tolerance, Sink sink)
    : tolerance_(tolerance), sink_(std::move(sink)) {}

bool PathThinning::straight(const Instant& to) const {
  if (waiting_.size() >= most_waiting ||
      (way(kept_.centre, to.centre) > beyond_rounding * tolerance_.travel && !to.force.empty())) {
    return false;
  }
  const double allowed = tolerance_.force * largest_force_;
  const double drive_allowed = tolerance_.drive_force * largest_drive_force_;
  for (const Instant& between : waiting_) {
    const double weight = (between.time - kept_.time) / (to.time - kept_.time);
    const auto off = [&](double from, double at, double end) {
      return std::abs(at - from - weight * (end - from));
    };
    if (off(kept_.centre[0], between.centre[0], to.centre[0]) > tolerance_.place ||
        off(kept_.centre[1], between.centre[1], to.centre[1]) > tolerance_.place ||
        off(kept_.height, between.height, to.height) > tolerance_.place ||
        off(kept_.drive_force[0], between.drive_force[0], to.drive_force[0]) > drive_allowed ||
        off(kept_.drive_force[1], between.drive_force[1], to.drive_force[1]) > drive_allowed ||
        off(kept_.area, between.area, to.area) > tolerance_.area * largest_area_ ||
        off(kept_.stick_share, between.stick_share, to.stick_share) > tolerance_.area) {
      return false;
    }
    if (!stays_straight(between, to, weight)) {
      return false;
    }
    const std::size_t size = std::max({kept_.force.size(), between.force.size(), to.force.size()});
    for (std::size_t i = 0; i < size; ++i) {
      if (off(component(kept_.force, i), component(between.force, i), component(to.force, i)) >
          allowed) {
        return false;
      }
    }
  }
  return true;
}

/// True if the displacement of the underside by tilt and rotation is linear in time from the last
/// stored instant to `to`.
bool PathThinning::stays_straight(const Instant& between, const Instant& to, double weight) const {
  if (!between.turned || !kept_.turned || !to.turned) {
    return !between.turned && !to.turned;
  }
  for (std::size_t cell = 0; cell < between.turned->size(); ++cell) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double from = (*kept_.turned)[cell][c], end = (*to.turned)[cell][c];
      // Cells far beyond the body do not count.
      if (std::abs((*between.turned)[cell][c] - from - weight * (end - from)) > tolerance_.place &&
          std::min({std::abs(from), std::abs(end)}) < far_beyond) {
        return false;
      }
    }
  }
  return true;
}

void PathThinning::keep() {
  Instant last = std::move(waiting_.back());
  waiting_.clear();
  kept_ = {last.time,        last.centre, last.height, last.required,    last.area,
           last.stick_share, last.force,  nullptr,     last.drive_force, last.turned};
  has_kept_ = true;
  if (last.state) {
    std::vector<double> total = last.state->slip;
    slip_kept_.resize(total.size());
    for (std::size_t cell = 0; cell < total.size(); ++cell) {
      last.state->slip[cell] -= slip_kept_[cell];
    }
    slip_kept_ = std::move(total);
  }
  sink_(std::move(last));
}

void PathThinning::add(Instant instant) {
  for (std::size_t i = 0; i < instant.force.size(); i += 3) {
    largest_force_ = std::max(largest_force_, instant.force[i]);
  }
  largest_area_ = std::max(largest_area_, instant.area);
  largest_drive_force_ =
      std::max(largest_drive_force_, way(instant.drive_force, std::array<double, 2>{}));
  if (!waiting_.empty() && instant.time <= waiting_.back().time) {
    instant.required = instant.required || waiting_.back().required;
    waiting_.pop_back();
  } else if (has_kept_ && waiting_.empty() && instant.time <= kept_.time) {
    return;
  } else if (!waiting_.empty() && (!has_kept_ || waiting_.back().required || !straight(instant))) {
    keep();
  }
  waiting_.push_back(std::move(instant));
}

void PathThinning::finish() {
  if (!waiting_.empty()) {
    keep();
  }
}

} // namespace ionskin::mechanics
