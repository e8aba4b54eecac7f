// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/live_contact.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

constexpr int most_corrections = 100; ///< largest number of iterations
/// Residuals, as `leave_residual` returns them, at which the iterations stop, and up to which the
/// result is valid [1].
constexpr double solved = 1e-9, nearly_solved = 1e-6;
/// Slip of a cell, as the force that its compliance makes of it and over the largest normal force
/// of a cell, up to which the cell rests [1]: some times what a step leaves as residual.
constexpr double at_rest = 1e-5;

/// Displacement of a point of the underside by a unit of a rigid motion: downward, along x, along y
/// [m/m] for translations, [m/rad] for rotations.
/// @param motion index of the motion, 0 to 5
/// @param at position of the point, from the slider's centre [m]
/// @param gap_by_yaw derivative of the gap at the point by the yaw [m/rad]
std::array<double, 3> moved(std::size_t motion, const std::array<double, 2>& at,
                            double gap_by_yaw) {
  switch (motion) {
  case 0:
    return {0, 1, 0};
  case 1:
    return {0, 0, 1};
  case 2:
    return {-1, 0, 0};
  case 3:
    return {-at[1], 0, 0};
  case 4:
    return {at[0], 0, 0};
  default:
    return {-gap_by_yaw, -at[1], at[0]};
  }
}

std::array<double, 2> times(const std::array<std::array<double, 2>, 2>& matrix, double x,
                            double y) {
  return {matrix[0][0] * x + matrix[0][1] * y, matrix[1][0] * x + matrix[1][1] * y};
}

} // namespace

/// Friction of a cell for the derivatives. At rest after a slide the traction of a cell equals its
/// limit, and rounding alone would decide whether the cell slips: it sticks.
laws::FrictionResponse LiveContact::friction_about(std::size_t cell, double normal,
                                                   const State& state) const noexcept {
  const laws::FrictionResponse response = friction_at(cell, normal, state);
  const double own = std::max(own_[3 * cell + 1], own_[3 * cell + 2]);
  const auto [x, y] = slip(cell, state);
  const bool rests = travel_[0] == 0 && travel_[1] == 0 && turn_ == 0;
  if (response.sticks || !rests || friction_.elastic_slip > 0 ||
      std::hypot(x, y) > at_rest * own * largest_) {
    return response;
  }
  return {true, response.traction, {{{1, 0}, {0, 1}}}, {}};
}

/// Fills `surface_by_motion_` with the residuals of the linearised contact equations for the forces
/// of `force_by_motion_`: normal displacements, positive downward [m], and tangential forces [N],
/// by a unit of each motion.
/// @returns largest residual displacement of a cell over the largest displacement by its motion [1]
double LiveContact::leave_residual(std::span<const std::size_t> touching,
                                   const State& state) noexcept {
  std::ranges::fill(surface_by_motion_, 0.0);
  for (const std::size_t cell : touching) {
    for (std::size_t at = 3 * cell; at < 3 * cell + 3; ++at) {
      const float* own = column(at);
      for (std::size_t motion = 0; motion < motions; ++motion) {
        const double force = force_by_motion_[motion * size_ + at];
        double* surface = surface_by_motion_.data() + motion * size_;
        for (std::size_t row = 0; row < size_ && force != 0; ++row) {
          surface[row] += force * static_cast<double>(own[row]);
        }
      }
    }
  }
  std::array<double, motions> missed{}, largest{};
  for (const std::size_t cell : touching) {
    const std::size_t at = 3 * cell;
    const laws::FrictionResponse response = friction_about(cell, state.force[at], state);
    const double own = std::max(own_[at + 1], own_[at + 2]);
    for (std::size_t motion = 0; motion < motions; ++motion) {
      const std::array<double, 3> way = moved(motion, middle_[cell], gap_by_yaw_[cell]);
      const double* force = force_by_motion_.data() + motion * size_ + at;
      double* surface = surface_by_motion_.data() + motion * size_ + at;
      const auto trial = times(response.by_trial, force[1] + (way[1] - surface[1]) / own,
                               force[2] + (way[2] - surface[2]) / own);
      surface[0] = way[0] - surface[0];
      for (std::size_t c = 0; c < 2; ++c) {
        surface[1 + c] = response.by_normal[c] * force[0] + trial[c] - force[1 + c];
        missed[motion] = std::max(missed[motion], own * std::abs(surface[1 + c]));
      }
      missed[motion] = std::max(missed[motion], std::abs(surface[0]));
      for (const double length : way) {
        largest[motion] = std::max(largest[motion], std::abs(length));
      }
    }
  }
  double worst = 0;
  for (std::size_t motion = 0; motion < motions; ++motion) {
    worst = std::max(worst, largest[motion] > 0 ? missed[motion] / largest[motion] : 0.0);
  }
  return worst;
}

/// Solves by iterative refinement, alternately for the normal and for the tangential forces as a
/// step does: factors in single precision, residuals in double precision.
bool LiveContact::stiffness(const State& state, std::span<double, 36> matrix) noexcept {
  std::ranges::fill(matrix, 0.0);
  std::ranges::fill(force_by_motion_, 0.0);
  if (!stepped_) {
    return false;
  }
  State begun = state;
  begun.memory = memory_before_;
  add_up(state);
  const std::span<const std::size_t> touching = find_touching(state);
  tangential_.clear();
  for (const std::size_t cell : touching) {
    const std::size_t at = 3 * cell;
    const laws::FrictionResponse response = friction_about(cell, state.force[at], begun);
    drag_[cell] = response.by_normal;
    tangential_.add(cell, std::max(own_[at + 1], own_[at + 2]), response.by_trial, {});
  }
  tangential_.take([&](std::size_t at) { return column(at); });
  if (touching.empty() || !take_normal(touching) || !tangential_.factor()) {
    return touching.empty();
  }
  double missed = leave_residual(touching, begun);
  for (int i = 0; i < most_corrections && missed > solved; ++i) {
    for (std::size_t motion = 0; motion < motions; ++motion) {
      const std::span change = std::span(change_).first(touching.size());
      for (std::size_t j = 0; j < touching.size(); ++j) {
        change[j] = static_cast<float>(surface_by_motion_[motion * size_ + 3 * touching[j]]);
      }
      correction_.solve(change);
      for (std::size_t j = 0; j < touching.size(); ++j) {
        const std::size_t cell = touching[j];
        double* force = force_by_motion_.data() + motion * size_ + 3 * cell;
        const auto normal = static_cast<double>(change[j]);
        force[0] += normal;
        force[1] += drag_[cell][0] * normal;
        force[2] += drag_[cell][1] * normal;
      }
    }
    leave_residual(touching, begun);
    for (std::size_t motion = 0; motion < motions; ++motion) {
      double* force = force_by_motion_.data() + motion * size_;
      const double* defect = surface_by_motion_.data() + motion * size_;
      for (const std::size_t cell : touching) {
        force[3 * cell + 1] += defect[3 * cell + 1];
        force[3 * cell + 2] += defect[3 * cell + 2];
      }
      tangential_.solve_factored([&](std::size_t cell) {
        return std::array{defect[3 * cell + 1], defect[3 * cell + 2]};
      });
      // Along the unknowns of `tangential_`, their solution replaces the residual force added
      // above.
      for (std::size_t k = 0; k < tangential_.count(); ++k) {
        const std::size_t at = 3 * tangential_.cell(k);
        const auto along = tangential_.direction(k);
        const auto change = tangential_.change(k);
        const double taken = along[0] * defect[at + 1] + along[1] * defect[at + 2];
        for (std::size_t c = 0; c < 2; ++c) {
          force[at + 1 + c] += change[c] - taken * along[c];
        }
      }
    }
    missed = leave_residual(touching, begun);
  }
  for (std::size_t motion = 0; motion < motions; ++motion) {
    for (const std::size_t cell : touching) {
      const double* force = force_by_motion_.data() + motion * size_ + 3 * cell;
      const auto [x, y] = middle_[cell];
      const std::array<double, 6> wrench{force[1],      force[2],     -force[0],
                                         -y * force[0], x * force[0], x * force[2] - y * force[1]};
      for (std::size_t row = 0; row < wrench.size(); ++row) {
        matrix[motions * row + motion] += wrench[row];
      }
    }
  }
  return missed <= nearly_solved;
}

} // namespace ionskin::live
