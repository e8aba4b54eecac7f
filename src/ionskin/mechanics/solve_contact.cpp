// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/base/interrupt.hpp"
#include "ionskin/base/task_pool.hpp"
#include "ionskin/mechanics/position_states.hpp"
#include "ionskin/mechanics/steady_sliding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// One slider position to be condensed, with the nodes of the track that share it.
struct PositionTask {
  std::array<double, 2> centre{};
  struct Node {
    std::size_t index = 0;
    CanonicalPosition position;
  };
  std::vector<Node> nodes;
};

bool same_place(const std::array<double, 2>& a, const std::array<double, 2>& b, const Skin& skin) {
  return std::abs(a[0] - b[0]) <= 1e-10 * skin.length &&
         std::abs(a[1] - b[1]) <= 1e-10 * skin.width;
}

std::vector<PositionTask> position_tasks(const Case& input,
                                         const std::vector<double>& arc_lengths) {
  const SliderTrack track(input);
  std::vector<PositionTask> tasks;
  for (std::size_t i = 0; i < arc_lengths.size(); ++i) {
    const auto position = canonical_position(input.skin, track.centre(arc_lengths[i]));
    auto task = std::find_if(tasks.begin(), tasks.end(), [&](const PositionTask& other) {
      return same_place(other.centre, position.centre, input.skin);
    });
    if (task == tasks.end()) {
      tasks.push_back({position.centre, {}});
      task = tasks.end() - 1;
    }
    task->nodes.push_back({i, position});
  }
  return tasks;
}

/// Threads whose factors fit together into the memory meant for them.
int threads_within_memory(const SkinModel& model, int threads) {
  constexpr double factor_memory = 2.4e9; // bytes
  const double per_factor = 8 * 1.1 * model.symbolic.factor_entries();
  return std::clamp(static_cast<int>(factor_memory / per_factor), 1, std::max(1, threads));
}

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

/// What is known at the start of the track and decides what the other positions mean.
struct SlideExtent {
  bool reaches_steady_sliding = true;
  std::vector<PathState> lift_off_from_onset; ///< used when steady sliding is never reached
  std::vector<double> final_surface;
};

/// The states of one friction coefficient at one condensed position.
class PositionSolver {
public:
  PositionSolver(const Case& input, const ContactOptions& options, const SkinModel& model,
                 const std::vector<double>& arc_lengths, const CondensedPosition& condensed,
                 double friction)
      : input_(input), options_(options), model_(model),
        arc_lengths_(arc_lengths), problem_{condensed.compliance(),
                                            model.cells.area,
                                            model.gap,
                                            {friction}},
        states_(model, input.motion.preload) {}

  /// Touchdown and onset, at the first node.
  void solve_start(const CanonicalPosition& position, ContactSolution& solution,
                   SlideExtent& extent) {
    CellVector before = options_.surface_before;
    if (!before.empty()) {
      before = reflected(model_.cells, before, position.reflect);
    }
    const SurfaceState touchdown = touch_down(problem_, input_.motion, before);
    const double scale = largest_normal_force(touchdown.force);
    solution.touchdown.parameter = 1;
    states_.add(solution.touchdown.state, touchdown, problem_, position, scale);
    const bool slides = input_.motion.stroke > 0;
    std::vector<PathPoint> onset;
    if (slides && problem_.friction.coefficient > 0) {
      const auto direction = position.reflected(input_.motion.direction);
      const double travel = onset_travel(
          touchdown,
          steady_sliding(problem_, {LoadKind::indentation, input_.motion.preload}, direction, 0),
          direction, options_.steps);
      extent.reaches_steady_sliding = travel < input_.motion.stroke;
      onset = slide_onset(problem_, input_.motion, direction, touchdown,
                          std::min(travel, input_.motion.stroke), options_.steps);
      add_path(onset, solution.onset, position, scale);
    }
    if (!slides || !extent.reaches_steady_sliding) {
      solve_lift_off(onset.empty() ? touchdown : onset.back().state, position,
                     extent.lift_off_from_onset, extent.final_surface);
      extent.reaches_steady_sliding = false;
    }
  }

  void solve_steady(std::size_t node, const CanonicalPosition& position,
                    ContactSolution& solution) {
    const double travel = node == 0 ? 0 : arc_lengths_[node] - arc_lengths_[node - 1];
    const SurfaceState steady =
        steady_sliding(problem_, {LoadKind::indentation, input_.motion.preload},
                       position.reflected(input_.motion.direction), travel);
    solution.steady[node].parameter = arc_lengths_[node];
    states_.add(solution.steady[node].state, steady, problem_, position,
                largest_normal_force(steady.force));
    if (node + 1 == arc_lengths_.size() && input_.motion.stroke > 0) {
      solve_lift_off(steady, position, solution.lift_off, solution.final_surface);
    }
  }

  void complete(const CondensedPosition& condensed) { states_.complete(condensed); }

private:
  void solve_lift_off(const SurfaceState& loaded, const CanonicalPosition& position,
                      std::vector<PathState>& path, std::vector<double>& final_surface) {
    const std::vector<PathPoint> points = lift_off(problem_, input_.motion, loaded, options_.steps);
    add_path(points, path, position, largest_normal_force(loaded.force));
    final_surface = reflected(model_.cells, points.back().state.surface, position.reflect);
  }

  void add_path(const std::vector<PathPoint>& points, std::vector<PathState>& path,
                const CanonicalPosition& position, double scale) {
    path.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      path[i].parameter = points[i].parameter;
      states_.add(path[i].state, points[i].state, problem_, position, scale);
    }
  }

  const Case& input_;
  const ContactOptions& options_;
  const SkinModel& model_;
  const std::vector<double>& arc_lengths_;
  ContactProblem problem_;
  PositionStates states_;
};

void for_each_state(const ContactSolution& solution, const auto& visit) {
  visit(solution.touchdown.state);
  for (const auto* path : {&solution.onset, &solution.steady, &solution.lift_off}) {
    for (const PathState& point : *path) {
      visit(point.state);
    }
  }
}

void summarise(const Case& input, double friction, SlideExtent extent, ContactSolution& solution) {
  if (!extent.reaches_steady_sliding) {
    solution.steady.clear();
    solution.lift_off = std::move(extent.lift_off_from_onset);
    solution.final_surface = std::move(extent.final_surface);
    if (input.motion.stroke > 0 && friction > 0) {
      solution.warnings.push_back(fmt::format("the stroke of {:.3g} um ends before the slider "
                                              "slides fully at a friction of {:.3g}; the whole "
                                              "slide is computed at the mesh of its start",
                                              input.motion.stroke * 1e6, friction));
    }
  }
  for_each_state(solution, [&](const ContactState& state) {
    solution.worst_equilibrium_residual =
        std::max(solution.worst_equilibrium_residual, state.equilibrium_residual);
    solution.worst_complementarity_residual =
        std::max(solution.worst_complementarity_residual, state.complementarity_residual);
    ++solution.contact_solves;
  });
}

} // namespace

std::vector<ContactSolution> solve_contact(const Case& input, const std::vector<double>& frictions,
                                           const ContactOptions& options, base::Timers& timers) {
  auto analysis = std::make_unique<base::Timers::Scope>(timers, "mechanics: analysis");
  const SkinModel model(input);
  analysis.reset();
  base::check_interrupt();

  const std::size_t node_count =
      options.nodes > 0 ? options.nodes : interpolation_node_count(input.numerics.preset);
  const std::vector<double> arc_lengths = input.motion.stroke > 0
                                              ? interpolation_nodes(input.motion.stroke, node_count)
                                              : std::vector<double>{0.0};
  const std::vector<PositionTask> tasks = position_tasks(input, arc_lengths);

  std::vector<ContactSolution> solutions;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    solutions.push_back({.mesh = model.mesh,
                         .cell_lines_x = model.cells.lines_x,
                         .cell_lines_y = model.cells.lines_y});
    solutions.back().steady.resize(arc_lengths.size());
  }
  std::vector<SlideExtent> extents(frictions.size());
  SharedProgress progress(options.progress, tasks.size() * (1 + frictions.size()));
  base::run_tasks(tasks.size(), threads_within_memory(model, options.threads), [&](std::size_t t) {
    base::check_interrupt();
    auto factorisation = std::make_unique<base::Timers::Scope>(timers, "mechanics: factorisation");
    const CondensedPosition condensed(model, tasks[t].centre);
    factorisation.reset();
    progress.finish_unit();
    for (std::size_t f = 0; f < frictions.size(); ++f) {
      base::check_interrupt();
      PositionSolver solver(input, options, model, arc_lengths, condensed, frictions[f]);
      {
        const base::Timers::Scope contact(timers, "mechanics: contact");
        for (const auto& node : tasks[t].nodes) {
          if (node.index == 0) {
            solver.solve_start(node.position, solutions[f], extents[f]);
          }
          solver.solve_steady(node.index, node.position, solutions[f]);
        }
      }
      const base::Timers::Scope strain(timers, "mechanics: strain");
      solver.complete(condensed);
      progress.finish_unit();
    }
  });
  for (std::size_t f = 0; f < frictions.size(); ++f) {
    summarise(input, frictions[f], std::move(extents[f]), solutions[f]);
  }
  return solutions;
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
  const SkinModel model(input);
  const SliderTrack track(input);
  std::vector<ContactState> result(arc_lengths.size());
  base::run_tasks(
      arc_lengths.size(), threads_within_memory(model, options.threads), [&](std::size_t i) {
        base::check_interrupt();
        const CanonicalPosition position{track.centre(arc_lengths[i]), {false, false}};
        const CondensedPosition condensed(model, position.centre);
        const ContactProblem problem{
            condensed.compliance(), model.cells.area, model.gap, {input.contact.friction}};
        const SurfaceState steady = steady_sliding(
            problem, {LoadKind::indentation, input.motion.preload}, input.motion.direction, 0);
        PositionStates states(model, input.motion.preload);
        states.add(result[i], steady, problem, position, largest_normal_force(steady.force));
        states.complete(condensed);
      });
  return result;
}

} // namespace ionskin::mechanics
