// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/slider_track.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// What is to be solved at one slider position, whose factorisation all of it shares. Nothing here
/// waits for another position: a leg that follows a slide starts from steady sliding, which is
/// solved on the spot. Should the slide turn out too short to become steady, the stepping that
/// began before it goes on through the following legs, and what started here is not used.
struct PositionTask {
  std::array<double, 2> centre{}; ///< canonical [m]

  /// Steady sliding at an interpolation node of a leg.
  struct Node {
    std::size_t leg = 0, index = 0;
    CanonicalPosition position;
  };
  /// Load steps from the begin of a leg.
  struct Chain {
    std::size_t leg = 0;
    CanonicalPosition position;
  };
  std::vector<Node> nodes;
  std::vector<Chain> chains; ///< ascending legs
};

/// Interpolation nodes of each leg; only those of legs that slide count.
using NodeCounts = std::vector<std::size_t>;

/// The legs of a cycle with the positions at which the contact is solved.
struct ContactPlan {
  std::vector<MotionLeg> legs;
  /// Interpolation nodes per leg: way since the begin of its contact [m]; empty unless it slides.
  std::vector<std::vector<double>> nodes;
  std::vector<PositionTask> positions;

  /// The first leg that does the same; the leg itself when none does.
  std::size_t first_alike(std::size_t leg) const;
  NodeCounts node_counts() const;
};

/// As many as the legs are expected to need.
NodeCounts expected_node_counts(const Case& input);

ContactPlan plan_contact(const Case& input, const NodeCounts& node_counts);

/// What a plan has beyond another one with fewer nodes.
std::vector<PositionTask> added_positions(const ContactPlan& plan, const ContactPlan& before);

} // namespace ionskin::mechanics
