// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/shared_positions.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/path/position_solver.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Enough for an efficient product, and little beside what the strains take for good.
constexpr std::size_t states_per_block = 48;

/// A position and what is to be solved there.
struct SharedPosition {
  struct Work {
    std::size_t solve = 0; ///< index of the friction coefficient
    const PositionTask* task = nullptr;
  };
  std::array<double, 2> centre{};
  std::vector<Work> works;
};

std::vector<SharedPosition> open_positions(const std::vector<FrictionSolve>& solves) {
  std::vector<SharedPosition> positions;
  for (std::size_t f = 0; f < solves.size(); ++f) {
    for (const PositionTask& task : solves[f].open) {
      auto position = std::ranges::find(positions, task.centre, &SharedPosition::centre);
      if (position == positions.end()) {
        position = positions.insert(position, {task.centre, {}});
      }
      position->works.push_back({f, &task});
    }
  }
  return positions;
}

/// @returns the states, which lack their strains
PositionStates contact_at(const SharedSetting& setting, const CondensedPosition& condensed,
                          const SharedPosition::Work& work, FrictionSolve& solve) {
  base::check_interrupt();
  const base::Timers::Scope contact(setting.timers, "mechanics: contact");
  PositionSolver solver(
      setting.model, solve.plan, solve.steps, setting.options.surface_before, condensed,
      laws::friction(setting.contact.law, solve.friction, setting.contact.parameters));
  solver.solve(*work.task, solve.pieces);
  setting.progress.finish_unit();
  return solver.take_states();
}

/// A position that holds no factor, and so is kept until all of it is solved.
struct LightPosition {
  std::unique_ptr<const CondensedPosition> condensed;
  PositionStates states;
};

/// States whose strains one thread recovers together. The last block of a position takes it along.
struct StrainBlock {
  std::shared_ptr<const LightPosition> position;
  std::size_t begin = 0, end = 0;
};

std::vector<StrainBlock> strain_blocks(std::vector<std::shared_ptr<LightPosition>> positions) {
  std::vector<StrainBlock> blocks;
  for (const auto& position : positions) {
    const std::size_t count = position->states.count();
    for (std::size_t begin = 0; begin < count; begin += states_per_block) {
      blocks.push_back({position, begin, std::min(count, begin + states_per_block)});
    }
  }
  return blocks;
}

void recover_strains(const SharedSetting& setting, std::vector<StrainBlock> blocks) {
  setting.progress.add_units(blocks.size());
  parallel::run_tasks(blocks.size(), setting.options.threads, [&](std::size_t i) {
    base::check_interrupt();
    const base::Timers::Scope strain(setting.timers, "mechanics: strain");
    const StrainBlock block = std::move(blocks[i]);
    block.position->states.complete(*block.position->condensed, block.begin, block.end);
    setting.progress.finish_unit();
  });
}

/// Directions of the forces of all works: a slide goes its way, load steps may stick across it.
ForceDirections force_directions(const SharedPosition& position,
                                 const std::vector<FrictionSolve>& solves) {
  ForceDirections directions{true, false, false};
  for (const SharedPosition::Work& work : position.works) {
    for (const PositionTask::Node& node : work.task->nodes) {
      const auto way = node.position.reflected(solves[work.solve].plan.legs[node.leg].direction());
      directions[1] = directions[1] || way[0] != 0;
      directions[2] = directions[2] || way[1] != 0;
    }
    if (!work.task->chains.empty()) {
      return {true, true, true};
    }
  }
  return directions;
}

/// Contact of all friction coefficients at a position that is gone with its factor. The strains of
/// each are recovered by themselves: products of BLAS round as the number of columns wants.
void solve_at_once(const SharedSetting& setting, const CondensedPosition& condensed,
                   const std::vector<SharedPosition::Work>& works,
                   std::vector<FrictionSolve>& solves) {
  for (const SharedPosition::Work& work : works) {
    const PositionStates states = contact_at(setting, condensed, work, solves[work.solve]);
    const base::Timers::Scope strain(setting.timers, "mechanics: strain");
    states.complete(condensed);
  }
}

/// Each friction coefficient is a task of its own, since most states belong to the first position.
/// @param light one per position, empty for what is solved already
void solve_light_positions(const SharedSetting& setting,
                           const std::vector<SharedPosition>& positions,
                           std::vector<std::unique_ptr<const CondensedPosition>> light,
                           std::vector<FrictionSolve>& solves) {
  std::vector<std::shared_ptr<LightPosition>> kept;
  std::vector<std::pair<LightPosition*, const SharedPosition::Work*>> works;
  for (std::size_t p = 0; p < positions.size(); ++p) {
    if (light[p]) {
      kept.push_back(std::make_shared<LightPosition>(
          LightPosition{std::move(light[p]), PositionStates(setting.model)}));
      for (const SharedPosition::Work& work : positions[p].works) {
        works.emplace_back(kept.back().get(), &work);
      }
    }
  }
  std::vector<PositionStates> states(works.size(), PositionStates(setting.model));
  parallel::run_tasks(works.size(), setting.options.threads, [&](std::size_t i) {
    const auto [position, work] = works[i];
    states[i] = contact_at(setting, *position->condensed, *work, solves[work->solve]);
  });
  for (std::size_t i = 0; i < works.size(); ++i) {
    works[i].first->states.append(std::move(states[i]));
  }
  recover_strains(setting, strain_blocks(std::move(kept)));
}

} // namespace

void solve_open_positions(const SharedSetting& setting, std::vector<FrictionSolve>& solves) {
  const std::vector<SharedPosition> positions = open_positions(solves);
  const int threads = setting.options.threads;
  for (const SharedPosition& position : positions) {
    setting.progress.add_units(1 + position.works.size());
  }
  std::vector<std::unique_ptr<const CondensedPosition>> light(positions.size());
  parallel::run_tasks(positions.size(), threads, [&](std::size_t p) {
    base::check_interrupt();
    auto factorisation =
        std::make_unique<base::Timers::Scope>(setting.timers, "mechanics: factorisation");
    const PositionUse use{setting.options.cache, force_directions(positions[p], solves)};
    auto condensed =
        std::make_unique<const CondensedPosition>(setting.model, positions[p].centre, use);
    factorisation.reset();
    setting.progress.finish_unit();
    if (condensed->holds_factor()) {
      solve_at_once(setting, *condensed, positions[p].works, solves);
    } else {
      light[p] = std::move(condensed);
    }
  });
  solve_light_positions(setting, positions, std::move(light), solves);
}

} // namespace ionskin::mechanics
