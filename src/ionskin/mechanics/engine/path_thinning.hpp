// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// Tolerances for the distance of a path from straight lines between its stored instants.
struct ThinningTolerance {
  double force = 0; ///< of a cell, over the largest normal force of a cell so far [1]
  /// Tolerance of the contact area, over the largest so far, and of the share of it that sticks
  /// [1].
  double area = 0;
  double place = 0;       ///< of the slider's centre and, in contact, of its height [m]
  double travel = 0;      ///< longest travel between stored instants [m]
  double drive_force = 0; ///< of the drive's force, over the largest so far [1]
};

/// Thins a path as it is computed: passes on only those instants between which cell forces and the
/// slider's position are linear within a tolerance. Each stored instant needs a strain, which is
/// costly, and makes a time step of Study 2 end there.
class PathThinning {
public:
  struct Instant {
    double time = 0;
    std::array<double, 2> centre{};
    double height = 0;
    bool required = false;
    double area = 0, stick_share = 0; ///< contact area, share of it that sticks [m2], [1]
    CellVector force;                 ///< on the cells [N]; empty off the skin
    /// Null off the skin. Its slip is counted from the begin of the path on entry, and from the
    /// stored instant before when it is passed on.
    std::shared_ptr<ContactState> state;
    std::array<double, 2> drive_force{}; ///< [N]
    /// Displacement of the underside at each cell, as `SteppedInstant::turned`; null where the
    /// angles never change.
    std::shared_ptr<const std::vector<std::array<double, 3>>> turned = {};
  };
  using Sink = std::function<void(Instant&&)>;

  /// @param sink receives the instants to store, in order
  PathThinning(const ThinningTolerance& tolerance, Sink sink);
  /// Adds the next instant. An instant that is not later than the last one replaces it, and is
  /// required if one of the two is; an instant that is not later than the last one passed on is
  /// dropped.
  void add(Instant instant);
  /// Passes on the last instant; to be called once, at the end of the path.
  void finish();

private:
  bool straight(const Instant& to) const;
  bool stays_straight(const Instant& between, const Instant& to, double weight) const;
  void keep();

  ThinningTolerance tolerance_;
  Sink sink_;
  Instant kept_; ///< last instant passed on, without its state
  bool has_kept_ = false;
  std::vector<Instant> waiting_; ///< instants after `kept_`, not decided yet
  double largest_force_ = 0, largest_area_ = 0, largest_drive_force_ = 0;
  std::vector<double> slip_kept_; ///< slip of each cell up to `kept_` [m]
};

} // namespace ionskin::mechanics
