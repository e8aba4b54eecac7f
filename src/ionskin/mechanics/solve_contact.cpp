// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/base/interrupt.hpp"
#include "ionskin/base/task_pool.hpp"
#include "ionskin/mechanics/contact_plan.hpp"
#include "ionskin/mechanics/find_footprint.hpp"
#include "ionskin/mechanics/position_solver.hpp"
#include "ionskin/mechanics/steady_sliding.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

namespace ionskin::mechanics {
namespace {

mesh::MeshedPart whole(const ContactOptions& options) {
  return options.full_model ? mesh::MeshedPart::whole : mesh::MeshedPart::half_if_symmetric;
}

/// From so many friction coefficients on, the response to every unit force is worth its making in
/// the same run.
constexpr std::size_t many_frictions = 3;

/// Reports progress from several threads, one at a time.
class SharedProgress {
public:
  SharedProgress(const base::ProgressCallback& callback, std::size_t units)
      : callback_(callback), units_(units) {}
  void finish_unit() {
    const std::lock_guard lock(mutex_);
    callback_("mechanics", static_cast<double>(++finished_) / static_cast<double>(units_));
  }

private:
  const base::ProgressCallback& callback_;
  std::size_t units_, finished_ = 0;
  std::mutex mutex_;
};

std::vector<ContactSolution> solve_on_footprint(const Case& input, const mesh::Footprint& footprint,
                                                const std::vector<double>& frictions,
                                                const ContactOptions& options,
                                                base::Timers& timers) {
  auto analysis = std::make_unique<base::Timers::Scope>(timers, "mechanics: analysis");
  const SkinModel model(input, footprint, whole(options));
  analysis.reset();
  base::check_interrupt();

  const ContactPlan plan = plan_contact(input, options.nodes);
  const std::vector<PositionTask>& tasks = plan.positions;
  std::vector<SolvedPieces> pieces(frictions.size(), SolvedPieces(plan));
  SharedProgress progress(options.progress, tasks.size() * (1 + frictions.size()));
  const auto solve = [&](std::size_t t, std::size_t f, const CondensedPosition& condensed) {
    base::check_interrupt();
    PositionSolver solver(model, plan, options.steps, options.surface_before, condensed,
                          {frictions[f], &friction_law(input.contact.law)});
    {
      const base::Timers::Scope contact(timers, "mechanics: contact");
      solver.solve(tasks[t], pieces[f]);
    }
    const base::Timers::Scope strain(timers, "mechanics: strain");
    solver.complete(condensed);
    progress.finish_unit();
  };
  // Positions that hold no factor are light: they are kept, and each of their friction coefficients
  // is a task of its own, since most states belong to the first position.
  std::vector<std::unique_ptr<const CondensedPosition>> light(tasks.size());
  base::run_tasks(tasks.size(), options.threads, [&](std::size_t t) {
    base::check_interrupt();
    auto factorisation = std::make_unique<base::Timers::Scope>(timers, "mechanics: factorisation");
    const PositionStore store{options.cache, frictions.size() >= many_frictions};
    auto condensed = std::make_unique<const CondensedPosition>(model, tasks[t].centre, store);
    factorisation.reset();
    progress.finish_unit();
    if (!condensed->holds_factor()) {
      light[t] = std::move(condensed);
      return;
    }
    for (std::size_t f = 0; f < frictions.size(); ++f) {
      solve(t, f, *condensed);
    }
  });
  base::run_tasks(tasks.size() * frictions.size(), options.threads, [&](std::size_t i) {
    const std::size_t t = i / frictions.size();
    if (light[t]) {
      solve(t, i % frictions.size(), *light[t]);
    }
  });
  std::vector<ContactSolution> solutions;
  for (std::size_t f = 0; f < frictions.size(); ++f) {
    solutions.push_back({.mesh = model.mesh,
                         .cell_lines_x = model.cells.lines_x,
                         .cell_lines_y = model.cells.lines_y});
    assemble(plan, pieces[f], frictions[f], solutions.back());
  }
  return solutions;
}

} // namespace

std::vector<ContactSolution> solve_contact(const Case& input, const std::vector<double>& frictions,
                                           const ContactOptions& options, base::Timers& timers) {
  mesh::Footprint footprint;
  if (options.footprint) {
    footprint = *options.footprint;
  } else {
    const base::Timers::Scope scope(timers, "mechanics: footprint");
    footprint = find_footprint(input, *std::max_element(frictions.begin(), frictions.end()),
                               options.threads);
  }
  for (;;) {
    auto solutions = solve_on_footprint(input, footprint, frictions, options, timers);
    const auto wider = widened_footprint(input, footprint, solutions);
    if (!wider) {
      return solutions;
    }
    footprint = *wider;
  }
}

ContactSolution solve_contact(const Case& input, const ContactOptions& options,
                              base::Timers& timers) {
  return std::move(
      solve_contact(input, std::vector<double>{input.contact.friction}, options, timers).front());
}

std::vector<ContactState> solve_steady_sliding(const Case& input,
                                               const std::vector<double>& arc_lengths,
                                               const ContactOptions& options,
                                               base::Timers& timers) {
  const base::Timers::Scope scope(timers, "mechanics: steady sliding");
  const SkinModel model(input, find_footprint(input, input.contact.friction, options.threads));
  const SliderTrack track(input);
  const MotionLeg leg = first_slide(motion_legs(input.motion, input.slider));
  const SliderLoad load = load_of(leg.to_level, model.mesh.half_model() ? 0.5 : 1.0);
  std::vector<ContactState> result(arc_lengths.size());
  base::run_tasks(arc_lengths.size(), options.threads, [&](std::size_t i) {
    base::check_interrupt();
    const CanonicalPosition position{track.centre(arc_lengths[i]), {false, false}};
    const CondensedPosition condensed(model, position.centre, {options.cache});
    const ContactProblem problem{condensed.compliance(),
                                 model.cells.area,
                                 model.gap,
                                 {input.contact.friction, &friction_law(input.contact.law)}};
    const SurfaceState steady = steady_sliding(problem, load, track.direction, 0);
    PositionStates states(model);
    states.add(result[i], steady, problem, position, largest_normal_force(steady.force),
               steady.indentation);
    states.complete(condensed);
  });
  return result;
}

} // namespace ionskin::mechanics
