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

/// Tolerance for the distance of a path from the straight lines between the instants that are kept
/// of it.
struct ThinningTolerance {
  double force = 0;  ///< of a cell, over the largest normal force of a cell so far [1]
  double area = 0;   ///< of the contact, over the largest so far, and share of it that sticks [1]
  double place = 0;  ///< of the slider's centre, and its height in contact [m]
  double travel = 0; ///< longest way between instants that are kept [m]
  double drive_force = 0; ///< of the drive, over the largest so far [1]
};

/// Keeps of a path the instants between which cell forces and the slider's place are linear, as it
/// comes: what follows needs their strains, which are costly, and its own time steps land on them.
class PathThinning {
public:
  struct Instant {
    double time = 0;
    std::array<double, 2> centre{};
    double height = 0;
    bool required = false;
    double area = 0, stick_share = 0;    ///< [m2], [1]
    CellVector force;                    ///< empty: detached
    std::shared_ptr<ContactState> state; ///< null: detached; slip since the begin of the path
    std::array<double, 2> drive_force{}; ///< [N]
    /// Underside at each cell, as ContactSolution keeps it; null where the angles never change.
    std::shared_ptr<const std::vector<std::array<double, 3>>> turned = {};
  };
  using Sink = std::function<void(Instant&&)>;

  PathThinning(const ThinningTolerance& tolerance, Sink sink);
  /// An instant not later than the last takes its place unless one of both is required.
  void add(Instant instant);
  /// Keeps the last instant; called once, at the end of the path.
  void finish();

private:
  bool straight(const Instant& to) const;
  bool stays_straight(const Instant& between, const Instant& to, double weight) const;
  void keep();

  ThinningTolerance tolerance_;
  Sink sink_;
  Instant kept_; ///< the last one that was kept, without its state
  bool has_kept_ = false;
  std::vector<Instant> waiting_; ///< behind it
  double largest_force_ = 0, largest_area_ = 0, largest_drive_force_ = 0;
  std::vector<double> slip_kept_; ///< of the last that was kept
};

} // namespace ionskin::mechanics
