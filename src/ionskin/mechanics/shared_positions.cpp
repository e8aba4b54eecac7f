// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/shared_positions.hpp"

#include "ionskin/base/interrupt.hpp"
#include "ionskin/base/task_pool.hpp"
#include "ionskin/mechanics/condensed_position.hpp"
#include "ionskin/mechanics/position_solver.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// From so many friction coefficients on, the response to every unit force is worth its making in
/// the same run.
constexpr std::size_t many_frictions = 3;

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

void solve_at(const SharedSetting& setting, const CondensedPosition& condensed,
              const SharedPosition::Work& work, FrictionSolve& solve) {
  base::check_interrupt();
  PositionSolver solver(setting.model, solve.plan, setting.options.steps,
                        setting.options.surface_before, condensed, {solve.friction, setting.law});
  {
    const base::Timers::Scope contact(setting.timers, "mechanics: contact");
    solver.solve(*work.task, solve.pieces);
  }
  const base::Timers::Scope strain(setting.timers, "mechanics: strain");
  solver.complete(condensed);
  setting.progress.finish_unit();
}

} // namespace

// Positions that hold no factor are light: they are kept, and each of their friction coefficients
// is a task of its own, since most states belong to the first position.
void solve_open_positions(const SharedSetting& setting, std::vector<FrictionSolve>& solves) {
  const std::vector<SharedPosition> positions = open_positions(solves);
  std::vector<std::pair<std::size_t, const SharedPosition::Work*>> works;
  for (std::size_t p = 0; p < positions.size(); ++p) {
    for (const SharedPosition::Work& work : positions[p].works) {
      works.emplace_back(p, &work);
    }
  }
  setting.progress.add_units(positions.size() + works.size());
  std::vector<std::unique_ptr<const CondensedPosition>> light(positions.size());
  base::run_tasks(positions.size(), setting.options.threads, [&](std::size_t p) {
    base::check_interrupt();
    auto factorisation =
        std::make_unique<base::Timers::Scope>(setting.timers, "mechanics: factorisation");
    const PositionStore store{setting.options.cache, solves.size() >= many_frictions};
    auto condensed = std::make_unique<const CondensedPosition>(setting.model, positions[p].centre,
                                                               store, setting.options.threads);
    factorisation.reset();
    setting.progress.finish_unit();
    if (!condensed->holds_factor()) {
      light[p] = std::move(condensed);
      return;
    }
    for (const SharedPosition::Work& work : positions[p].works) {
      solve_at(setting, *condensed, work, solves[work.solve]);
    }
  });
  base::run_tasks(works.size(), setting.options.threads, [&](std::size_t i) {
    const auto [p, work] = works[i];
    if (light[p]) {
      solve_at(setting, *light[p], *work, solves[work->solve]);
    }
  });
}

} // namespace ionskin::mechanics
