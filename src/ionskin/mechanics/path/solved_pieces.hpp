// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/path/contact_plan.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Load steps from the begin of a leg on, through all following legs until sliding is steady or the
/// slider detached. The path of each leg lacks its first state, which belongs to the leg before.
struct SolvedChain {
  struct Leg {
    double begin = 0, joined = 0; ///< as in LegPath
    bool steady = false;
    std::vector<PathState> points;
    std::vector<SharedState> reference;
  };
  std::vector<Leg> legs;
  std::vector<double> final_surface; ///< after lift-off; empty when there is none
};

/// All that the positions of a plan give for one friction coefficient. Every position writes
/// entries of its own.
struct SolvedPieces {
  explicit SolvedPieces(const ContactPlan& plan);
  /// Makes room for the nodes that a plan has beyond the one that was solved.
  void extend(const ContactPlan& solved, const ContactPlan& plan);
  std::vector<SolvedChain> chains;            ///< by the leg with which they begin
  std::vector<std::vector<PathState>> steady; ///< by leg
};

/// Puts the pieces together leg by leg: where a slide ends before it is steady, its chain goes on;
/// where it is steady, the chain that begins there takes over.
void assemble(const ContactPlan& plan, const SolvedPieces& pieces, double friction,
              ContactSolution& solution);

} // namespace ionskin::mechanics
