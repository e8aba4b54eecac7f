// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/kept_path.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/engine/contact_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {

KeptPath::KeptPath(const SkinModel& model, std::shared_ptr<SteppedStrains> strains,
                   const ThinningTolerance& tolerance, ContactSolution& solution)
    : model_(model), strains_(std::move(strains)), solution_(solution),
      thinning_(tolerance, [this](PathThinning::Instant&& instant) { keep(std::move(instant)); }),
      total_slip_(model.cells.count(), 0.0) {}

void KeptPath::add(const StepPoint& point, const SlidingContact& contact) {
  PathThinning::Instant instant{point.time, point.centre, point.height, point.required,   0,
                                0,          {},           {},           point.drive_force};
  instant.turned = contact.turned();
  const SurfaceState& state = contact.state();
  if (point.touches) {
    largest_force_ = std::max(largest_force_, largest_normal_force(state.force));
    largest_indentation_ = std::max(largest_indentation_, std::abs(state.indentation));
    instant.force = state.force;
    instant.state = std::make_shared<ContactState>();
    // There is no indentation on landing to compare with the lift of the face by other sliders.
    const double reference =
        largest_indentation_ > 0 ? largest_indentation_ : std::numeric_limits<double>::infinity();
    describe(model_, state, contact.problem(), largest_force_, reference, *instant.state);
    if (point.time > last_time_) { // the slip of an instant that comes twice counts once
      for (std::size_t cell = 0; cell < total_slip_.size(); ++cell) {
        total_slip_[cell] += state.slip[cell];
      }
    }
    instant.state->slip = total_slip_;
    instant.area = instant.state->contact_area;
    instant.stick_share = instant.area > 0 ? instant.state->stick_area / instant.area : 0;
    solution_.worst_complementarity_residual = base::nan_max(
        solution_.worst_complementarity_residual, instant.state->complementarity_residual);
  } else if (const double depth = unresisted_depth(point, contact); depth > 0) {
    solution_.worst_complementarity_residual = base::nan_max(
        solution_.worst_complementarity_residual, depth / std::max(depth, largest_indentation_));
  }
  last_time_ = point.time;
  thinning_.add(std::move(instant));
}

/// Depth of a slider without load below the first point of the skin that it would touch [m]; an
/// error if above 0.
double KeptPath::unresisted_depth(const StepPoint& point, const SlidingContact& contact) {
  return -point.height - contact.problem().least_free_gap();
}

void KeptPath::keep(PathThinning::Instant&& instant) {
  if (instant.state) {
    instant.state->place = strains_->add(instant.centre, std::move(instant.force));
    instant.state->source = strains_;
  }
  solution_.stepped.push_back({instant.time, instant.centre, instant.height,
                               std::move(instant.state), instant.drive_force,
                               std::move(instant.turned)});
}

} // namespace ionskin::mechanics
