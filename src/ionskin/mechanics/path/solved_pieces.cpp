// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/solved_pieces.hpp"

#include "ionskin/base/largest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ionskin::mechanics {
namespace {

LegSolution leg_solution(const MotionLeg& motion, const SolvedChain::Leg& solved,
                         const std::vector<PathState>& steady, const SharedState& before) {
  LegSolution leg;
  leg.joined = solved.joined;
  if (solved.steady) {
    leg.steady = steady;
  }
  if (!solved.steady || !solved.points.empty()) {
    leg.path.push_back({solved.begin, before});
    leg.path.insert(leg.path.end(), solved.points.begin(), solved.points.end());
  }
  if (solved.steady && !leg.path.empty()) {
    const SharedState first = motion.lands() ? nullptr : steady.front().state;
    leg.reference.assign(leg.path.size(), first);
    std::copy(solved.reference.begin(), solved.reference.end(), leg.reference.begin() + 1);
  }
  return leg;
}

void warn_of_short_slides(const ContactPlan& plan, double friction, ContactSolution& solution) {
  int count = 0;
  double longest = 0;
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    if (plan.legs[i].slides() && solution.legs[i].steady.empty()) {
      ++count;
      longest = std::max(longest, plan.legs[i].length());
    }
  }
  if (count > 0) {
    const std::string which =
        count == 1 ? fmt::format("a slide of {:.3g} um ends", longest * 1e6)
                   : fmt::format("{} slides of at most {:.3g} um end", count, longest * 1e6);
    solution.warnings.push_back(
        fmt::format("{} before the slider slides fully at a friction of {:.3g}; until it does so "
                    "all is computed on the mesh of the place where it began",
                    which, friction));
  }
}

void summarise(ContactSolution& solution) {
  std::set<const ContactState*> states;
  for (const LegSolution& leg : solution.legs) {
    for (const auto* path : {&leg.path, &leg.steady}) {
      for (const PathState& point : *path) {
        states.insert(point.state.get());
      }
    }
    for (const SharedState& state : leg.reference) {
      states.insert(state.get());
    }
  }
  states.erase(nullptr);
  for (const ContactState* state : states) {
    solution.worst_equilibrium_residual =
        base::larger(solution.worst_equilibrium_residual, state->equilibrium_residual);
    solution.worst_complementarity_residual =
        base::larger(solution.worst_complementarity_residual, state->complementarity_residual);
  }
  solution.contact_solves = static_cast<int>(states.size());
}

} // namespace

SolvedPieces::SolvedPieces(const ContactPlan& plan)
    : chains(plan.legs.size()), steady(plan.legs.size()) {
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    steady[leg].resize(plan.nodes[leg].size());
  }
}

void SolvedPieces::extend(const ContactPlan& solved, const ContactPlan& plan) {
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    std::vector<PathState> states(plan.nodes[leg].size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto place = std::ranges::find(solved.nodes[leg], plan.nodes[leg][i]);
      if (place != solved.nodes[leg].end()) {
        states[i] = steady[leg][static_cast<std::size_t>(place - solved.nodes[leg].begin())];
      }
    }
    steady[leg] = std::move(states);
  }
}

void assemble(const ContactPlan& plan, const SolvedPieces& pieces, double friction,
              ContactSolution& solution) {
  solution.legs.resize(plan.legs.size());
  for (std::size_t begin = 0; begin < plan.legs.size();) {
    const SolvedChain& chain = pieces.chains[begin];
    for (std::size_t i = 0; i < chain.legs.size(); ++i) {
      const std::size_t leg = begin + i;
      const bool lands = plan.legs[leg].lands();
      solution.legs[leg] =
          leg_solution(plan.legs[leg], chain.legs[i], pieces.steady[plan.first_alike(leg)],
                       lands ? nullptr : solution.legs[leg - 1].last());
    }
    if (solution.final_surface.empty()) {
      solution.final_surface = chain.final_surface;
    }
    begin += std::max<std::size_t>(1, chain.legs.size()); // detached legs have no chain
  }
  warn_of_short_slides(plan, friction, solution);
  summarise(solution);
}

} // namespace ionskin::mechanics
