// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/mechanics/path/expected_steps.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/run/solve_mechanics.hpp"
#include "ionskin/study/store/mechanics_file.hpp"
#include "ionskin/study/store/mechanics_store.hpp"
#include "ionskin/study/sweep/point_failure.hpp"

#include <algorithm>
#include <memory>
#include <optional>

namespace ionskin::study {
namespace {

/// Bound on the memory of contact solutions held at once [bytes]; further solutions wait for the
/// next batch.
constexpr double most_memory = 4e8;
/// Number of values per contact cell in a state of the path: its tractions, forces, displacement,
/// slip and stick reserve.
constexpr double values_per_cell = 16;
/// Number of states whose strain a solution holds while its history is made, and number of
/// histories made at once.
constexpr double held_states = 48;
constexpr std::size_t histories_at_once = 2;

/// Points with the same Study 1.
struct SharedMechanics {
  double friction = 0;
  std::vector<std::size_t> points;
};
/// Solutions that differ only in the friction coefficient, and can share a footprint.
using FrictionGroup = std::vector<SharedMechanics>;

RunOptions point_options(const RunOptions& options, const SweepPoint& point) {
  RunOptions result = options;
  result.folder = options.folder / point.name;
  return result;
}

/// Hash that is equal for cases that can share the skin and its compliance: `mechanics_hash`
/// without the exact friction coefficient.
std::string hash_of_group(Case input) {
  input.contact.friction =
      input.slider.sharp() ? 0 : mechanics::footprint_friction(input.contact.friction);
  return mechanics_hash(input);
}

std::vector<FrictionGroup> group_points(const std::vector<SweepPoint>& points,
                                        const std::vector<std::size_t>& chosen) {
  std::map<std::string, std::map<std::string, SharedMechanics>> groups;
  std::vector<std::string> order;
  for (const std::size_t i : chosen) {
    const std::string group = hash_of_group(points[i].input);
    if (groups.count(group) == 0) {
      order.push_back(group);
    }
    SharedMechanics& shared = groups[group][points[i].mechanics_hash];
    shared.friction = points[i].input.contact.friction;
    shared.points.push_back(i);
  }
  std::vector<FrictionGroup> result;
  for (const std::string& name : order) {
    FrictionGroup& group = result.emplace_back();
    for (auto& [hash, shared] : groups[name]) {
      group.push_back(std::move(shared));
    }
    std::sort(group.begin(), group.end(),
              [](const auto& a, const auto& b) { return a.points.front() < b.points.front(); });
  }
  return result;
}

double solution_memory(const Case& input, const mesh::SkinMesh& mesh) {
  const auto cells = static_cast<double>(mechanics::contact_cells(mesh).count());
  const std::size_t states = std::max<std::size_t>(1, mechanics::expected_steps(input).kept);
  return values_per_cell * sizeof(double) * cells * static_cast<double>(states);
}

double strain_memory(const mesh::SkinMesh& mesh) {
  const auto elements = mesh.elements();
  const auto core = mesh.core_z();
  const double gauss_points =
      8.0 * static_cast<double>(elements[0] * elements[1] * (core[1] - core[0]));
  return held_states * 6 * sizeof(double) * gauss_points;
}

/// Number of friction coefficients whose solutions fit into memory together.
std::size_t batch_size(const Case& input, const mesh::Footprint& footprint) {
  const mesh::SkinMesh mesh(input, footprint);
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(most_memory / solution_memory(input, mesh)));
}

/// Plan for solving the entries of a group.
struct GroupPlan {
  std::size_t batch = 1; ///< number of entries solved at once
  /// Footprint that all entries share; empty: each finds its own.
  std::optional<mesh::Footprint> footprint;
};

/// Plans a group. Without a footprint that all can share, each entry is solved by itself, and fails
/// by itself where the contact leaves the skin.
GroupPlan plan_group(const Case& input, int threads) {
  GroupPlan plan;
  failure_of([&] {
    const auto found = mechanics::find_footprint(input, input.contact.friction, threads);
    if (found.shared) {
      plan = {batch_size(input, found.footprint), found.footprint};
    }
  });
  return plan;
}

/// Writes the mechanics of another point into the run folder of a point.
void take_over(const SweepPoint& point, const RunOptions& options, const MechanicsRecord& record) {
  RunFolder folder(point.input, point_options(options, point));
  folder.stage("strain", [&] {
    write_mechanics(folder.own(results::file_names::results), point.mechanics_hash, record);
    return true;
  });
}

/// Writes a solution into the run folders of all points that share it.
/// @param seconds wall time of the solution [s]
void leave_in_folders(const std::vector<SweepPoint>& points, const SharedMechanics& shared,
                      const SolvedMechanics& solved, double seconds, const RunOptions& options) {
  const Case& input = points[shared.points.front()].input;
  std::optional<std::filesystem::path> first;
  for (const std::size_t i : shared.points) {
    RunFolder folder(points[i].input, point_options(options, points[i]));
    folder.add_finished("mechanics", first ? 0.0 : seconds, first ? "another point" : "");
    folder.stage("strain", [&] {
      const auto path = folder.own(results::file_names::results);
      if (first) {
        base::PendingFile pending(path);
        std::filesystem::copy_file(*first, pending.path(),
                                   std::filesystem::copy_options::overwrite_existing);
        pending.commit();
      } else {
        write_mechanics(path, points[i].mechanics_hash, record_mechanics(input, solved));
        first = path;
      }
      return true;
    });
  }
}

/// Finished fraction of the mechanics, 0 to 1; footprint and coarser meshes come first.
double finished_share(std::string_view activity, double fraction) {
  constexpr double of_footprint = 0.05, before_mechanics = 0.15;
  if (activity == "contact footprint") {
    return of_footprint * fraction;
  }
  return activity == "mechanics" ? before_mechanics + (1 - before_mechanics) * fraction
                                 : of_footprint + (before_mechanics - of_footprint) * fraction;
}

class SharedMechanicsSolver {
public:
  SharedMechanicsSolver(const std::vector<SweepPoint>& points, const RunOptions& options,
                        base::Timers& timers, std::size_t units)
      : points_(points), options_(options), timers_(timers), units_(units) {}

  /// Solves entries [begin, end) of a group together; if that fails, each half by itself.
  /// @param footprint that all of them share; empty to find it
  void solve(const FrictionGroup& group, std::size_t begin, std::size_t end,
             const std::optional<mesh::Footprint>& footprint) {
    const double start = base::wall_time();
    std::vector<SolvedMechanics> solutions;
    const auto spare = std::make_shared<parallel::SpareThreads>();
    const auto reason =
        failure_of([&] { solutions = solve_together(group, begin, end, footprint, spare); });
    if (!reason) {
      const double seconds = (base::wall_time() - start) / static_cast<double>(end - begin);
      leave(group, begin, std::move(solutions), seconds, *spare);
    } else if (end - begin > 1) {
      const std::size_t middle = begin + (end - begin) / 2;
      solve(group, begin, middle, footprint);
      solve(group, middle, end, footprint);
      return;
    } else {
      for (const std::size_t i : group[begin].points) {
        failures[i] = *reason;
      }
    }
    finished_ += end - begin;
    options_.progress("mechanics of all points",
                      static_cast<double>(finished_) / static_cast<double>(units_));
  }

  SweepFailures failures;

private:
  std::vector<SolvedMechanics>
  solve_together(const FrictionGroup& group, std::size_t begin, std::size_t end,
                 const std::optional<mesh::Footprint>& footprint,
                 const std::shared_ptr<parallel::SpareThreads>& spare) {
    const double before = static_cast<double>(finished_) / static_cast<double>(units_);
    const double share = static_cast<double>(end - begin) / static_cast<double>(units_);
    mechanics::ContactOptions contact_options;
    contact_options.threads = options_.threads;
    contact_options.footprint = footprint;
    contact_options.spare = spare;
    contact_options.progress = [&](std::string_view activity, double fraction) {
      options_.progress("mechanics of all points",
                        before + share * finished_share(activity, fraction));
    };
    std::vector<double> frictions;
    for (std::size_t i = begin; i < end; ++i) {
      frictions.push_back(group[i].friction);
    }
    return solve_mechanics(points_[group[begin].points.front()].input, frictions, contact_options,
                           timers_);
  }

  void leave(const FrictionGroup& group, std::size_t begin, std::vector<SolvedMechanics> solutions,
             double seconds, parallel::SpareThreads& spare) {
    // One thread recovers the strains of a solution; threads without a solution of their own help.
    parallel::run_tasks(
        solutions.size(), options_.threads,
        [&](std::size_t i) {
          const auto solved = std::make_unique<SolvedMechanics>(std::move(solutions[i]));
          leave_in_folders(points_, group[begin + i], *solved, seconds, options_);
        },
        &spare);
  }

  const std::vector<SweepPoint>& points_;
  const RunOptions& options_;
  base::Timers& timers_;
  std::size_t units_, finished_ = 0;
};

/// Copies Study 1 that is solved already into the run folders of points, and returns the points
/// that are still to be solved.
std::vector<std::size_t> points_to_solve(const std::vector<SweepPoint>& points,
                                         const std::vector<std::size_t>& unfinished,
                                         const RunOptions& options,
                                         const std::filesystem::path& others) {
  MechanicsStore store;
  for (const SweepPoint& point : points) {
    for (const auto& folder : {options.folder, others}) {
      store.add(point.mechanics_hash, folder / point.name / results::file_names::results);
    }
  }
  std::vector<std::size_t> result;
  for (const std::size_t i : unfinished) {
    const SweepPoint& point = points[i];
    const auto own = point_options(options, point).folder / results::file_names::results;
    if (point.mechanics_hash.empty() || MechanicsStore::holds(own, point.mechanics_hash)) {
      continue;
    }
    if (const auto record = store.read(point.mechanics_hash, point.input.skin)) {
      take_over(point, options, *record);
    } else {
      result.push_back(i);
    }
  }
  return result;
}

} // namespace

double solutions_memory(const Case& input, std::size_t solutions) {
  const mesh::SkinMesh mesh(input);
  const auto histories = static_cast<double>(std::min(solutions, histories_at_once));
  return std::min(most_memory, static_cast<double>(solutions) * solution_memory(input, mesh)) +
         histories * strain_memory(mesh);
}

std::vector<MechanicsGroup> mechanics_groups(const std::vector<SweepPoint>& points) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].input.strain.kind == StrainSourceKind::contact) {
      chosen.push_back(i);
    }
  }
  std::vector<MechanicsGroup> result;
  for (const FrictionGroup& group : group_points(points, chosen)) {
    MechanicsGroup& made = result.emplace_back();
    for (const SharedMechanics& shared : group) {
      made.solutions.push_back(shared.points);
    }
  }
  return result;
}

SweepFailures solve_shared_mechanics(const std::vector<SweepPoint>& points,
                                     const std::vector<std::size_t>& unfinished,
                                     const RunOptions& options, const std::filesystem::path& others,
                                     base::Timers& timers) {
  const std::vector<std::size_t> to_solve = points_to_solve(points, unfinished, options, others);
  const std::vector<FrictionGroup> groups = group_points(points, to_solve);
  std::size_t units = 0;
  for (const FrictionGroup& group : groups) {
    units += group.size();
  }
  if (units > 0) {
    options.progress("mechanics of all points", 0.0);
  }
  SharedMechanicsSolver solver(points, options, timers, units);
  for (const FrictionGroup& group : groups) {
    const Case& input = points[group.front().points.front()].input;
    const GroupPlan plan = plan_group(input, options.threads);
    for (std::size_t begin = 0; begin < group.size(); begin += plan.batch) {
      solver.solve(group, begin, std::min(group.size(), begin + plan.batch), plan.footprint);
    }
  }
  return std::move(solver.failures);
}

} // namespace ionskin::study
