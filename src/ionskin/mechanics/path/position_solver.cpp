// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/position_solver.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {

PositionSolver::PositionSolver(const SkinModel& model, const ContactPlan& plan,
                               const PathSteps& steps, const std::vector<double>& surface_before,
                               const CondensedPosition& condensed, const laws::Friction& friction)
    : model_(model), plan_(plan), steps_(steps), surface_before_(surface_before),
      meshed_share_(model.mesh.half_model() ? 0.5 : 1.0), problem_{contact_compliance(model,
                                                                                      condensed),
                                                                   model.cells.area, model.gap,
                                                                   friction},
      states_(model) {}

void PositionSolver::Scale::include(const SurfaceState& state) {
  force = std::max(force, largest_normal_force(state.force));
  indentation = std::max(indentation, state.indentation);
}

SharedState PositionSolver::keep(const SurfaceState& state, const CanonicalPosition& position,
                                 const Scale& scale) {
  auto kept = std::make_shared<ContactState>();
  states_.add(*kept, state, problem_, position, scale.force, scale.indentation);
  return kept;
}

void PositionSolver::turn_slider(const CanonicalPosition& position) {
  const std::size_t count = model_.gap.size();
  CellVector heights(3 * count, 0.0);
  for (std::size_t cell = 0; cell < count; ++cell) {
    heights[3 * cell] = model_.gap[cell];
  }
  heights = reflected(model_.cells, heights, position.reflect);
  for (std::size_t cell = 0; cell < count; ++cell) {
    problem_.gap[cell] = heights[3 * cell];
  }
}

void PositionSolver::solve(const PositionTask& task, SolvedPieces& pieces) {
  for (const auto& node : task.nodes) {
    solve_node(node, pieces);
  }
  for (const auto& chain : task.chains) {
    base::check_interrupt();
    if (const SolvedChain* alike = solved_alike(task, chain, pieces)) {
      pieces.chains[chain.leg] = *alike;
    } else {
      solve_chain(chain, pieces);
    }
  }
}

void PositionSolver::solve_node(const PositionTask::Node& node, SolvedPieces& pieces) {
  turn_slider(node.position);
  const MotionLeg& leg = plan_.legs[node.leg];
  const ContactPart part = contact_part(leg);
  const std::vector<double>& ways = plan_.nodes[node.leg];
  const double fraction = ways[node.index] / ways.back();
  PathState& point = pieces.steady[node.leg][node.index];
  point.time = part.begin + fraction * part.duration;
  const SliderLoad load = load_of(part, fraction, meshed_share_);
  if (load.value <= 0) {
    return; // the slider just lands or leaves here
  }
  const SurfaceState steady =
      steady_sliding(problem_, load, node.position.reflected(leg.direction()), ways.back());
  Scale scale;
  scale.include(steady);
  point.state = keep(steady, node.position, scale);
}

const SolvedChain* PositionSolver::solved_alike(const PositionTask& task,
                                                const PositionTask::Chain& chain,
                                                const SolvedPieces& pieces) const {
  const auto alike = [&](std::size_t a, std::size_t b) {
    return b < plan_.legs.size() && plan_.legs[a].repeats(plan_.legs[b]);
  };
  for (const auto& other : task.chains) {
    if (other.leg >= chain.leg) {
      break;
    }
    const SolvedChain& solved = pieces.chains[other.leg];
    bool same = plan_.legs[chain.leg].lands()
                    ? other.leg > 0 || surface_before_.empty()
                    : other.leg > 0 && alike(other.leg - 1, chain.leg - 1);
    for (std::size_t i = 0; i < solved.legs.size(); ++i) {
      same = same && alike(other.leg + i, chain.leg + i);
    }
    if (same) {
      return &solved;
    }
  }
  return nullptr;
}

void PositionSolver::solve_chain(const PositionTask::Chain& chain, SolvedPieces& pieces) {
  const CanonicalPosition& position = chain.position;
  turn_slider(position);
  ContactPath path(problem_, steps_, meshed_share_);
  if (plan_.legs[chain.leg].lands()) {
    const bool left_over = chain.leg == 0 && !surface_before_.empty();
    path.start_detached(left_over ? reflected(model_.cells, surface_before_, position.reflect)
                                  : CellVector{});
  } else {
    const MotionLeg& before = plan_.legs[chain.leg - 1];
    path.start_sliding(before.to_level, position.reflected(before.direction()));
  }
  Scale scale;
  scale.include(path.state());

  std::vector<LegPath> followed;
  SolvedChain& solved = pieces.chains[chain.leg];
  for (std::size_t leg = chain.leg; leg < plan_.legs.size() && plan_.legs[leg].touches(); ++leg) {
    followed.push_back(
        path.follow(plan_.legs[leg], position.reflected(plan_.legs[leg].direction())));
    for (const PathPoint& point : followed.back().points) {
      scale.include(point.state);
    }
    if (followed.back().steady) {
      break;
    }
    if (plan_.legs[leg].leaves()) {
      solved.final_surface = reflected(model_.cells, path.state().surface, position.reflect);
      break;
    }
  }
  for (const LegPath& leg : followed) {
    SolvedChain::Leg& kept =
        solved.legs.emplace_back(SolvedChain::Leg{leg.begin, leg.joined, leg.steady, {}, {}});
    for (const PathPoint& point : leg.points) {
      kept.points.push_back({point.time, keep(point.state, position, scale)});
    }
    for (const SurfaceState& state : leg.reference) {
      kept.reference.push_back(state.indentation > 0 ? keep(state, position, scale) : nullptr);
    }
  }
}

} // namespace ionskin::mechanics
