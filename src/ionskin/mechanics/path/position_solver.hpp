// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/path/contact_path.hpp"
#include "ionskin/mechanics/path/position_states.hpp"
#include "ionskin/mechanics/path/solved_pieces.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

/// The states of one friction coefficient at one condensed position.
class PositionSolver {
public:
  /// @param surface_before displacement that an earlier cycle left under the first touchdown [m];
  /// empty for none
  PositionSolver(const SkinModel& model, const ContactPlan& plan, const PathSteps& steps,
                 const std::vector<double>& surface_before, const CondensedPosition& condensed,
                 const laws::Friction& friction);

  /// Contact of everything that a position is planned for, without strains.
  void solve(const PositionTask& task, SolvedPieces& pieces);
  /// The states solved so far, which wait for their strains.
  PositionStates take_states() { return std::move(states_); }

private:
  /// Scales of the diagnostics.
  struct Scale {
    double force = 0;       ///< largest normal force of a cell [N]
    double indentation = 0; ///< [m]
    void include(const SurfaceState& state);
  };

  /// Turns the slider's underside as the canonical position sees it.
  void turn_slider(const CanonicalPosition& position);
  void solve_node(const PositionTask::Node& node, SolvedPieces& pieces);
  void solve_chain(const PositionTask::Chain& chain, SolvedPieces& pieces);
  /// An earlier chain here that goes the same way, or nullptr.
  const SolvedChain* solved_alike(const PositionTask& task, const PositionTask::Chain& chain,
                                  const SolvedPieces& pieces) const;
  SharedState keep(const SurfaceState& state, const CanonicalPosition& position,
                   const Scale& scale);

  const SkinModel& model_;
  const ContactPlan& plan_;
  const PathSteps& steps_;
  const std::vector<double>& surface_before_;
  double meshed_share_;
  ContactProblem problem_;
  PositionStates states_;
};

} // namespace ionskin::mechanics
