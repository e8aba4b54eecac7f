// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/position/memory_estimate.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/run/solve_mechanics.hpp"
#include "ionskin/study/run/user_cache.hpp"
#include "ionskin/study/store/mechanics_cache.hpp"
#include "ionskin/study/store/mechanics_file.hpp"
#include "ionskin/study/sweep/point_failure.hpp"

#include <algorithm>
#include <memory>
#include <optional>

namespace ionskin::study {
namespace {

// For the contact solutions held at once: so many bytes, or so much of what a factorisation takes
// anyway. What does not fit is solved in a further batch, which factorises all positions again.
constexpr double least_solution_memory = 1.2e9, share_of_factorisation = 0.5;
// States of a touchdown, an onset with the steady sliding behind it, and a lift-off.
constexpr double touchdown_states = 20, slide_states = 38, lift_off_states = 20;

/// Points with one and the same Study 1.
struct SharedMechanics {
  double friction = 0;
  std::vector<std::size_t> points;
};
/// Those of them that differ in the friction coefficient only, and can share a footprint.
using FrictionGroup = std::vector<SharedMechanics>;

RunOptions point_options(const RunOptions& options, const SweepPoint& point) {
  RunOptions result = options;
  result.folder = options.folder / point.name;
  return result;
}

/// Equal for cases that can share all factorisations.
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
    SharedMechanics& shared = groups[group][mechanics_hash(points[i].input)];
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

double states_per_solution(const Case& input) {
  double states = 0;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    states += (leg.lands() ? touchdown_states : 0) + (leg.slides() ? slide_states : 0) +
              (leg.leaves() ? lift_off_states : 0);
  }
  return states;
}

/// Friction coefficients whose solutions fit into memory together.
std::size_t batch_size(const Case& input, const mesh::Footprint& footprint) {
  const mesh::SkinMesh mesh(input, footprint);
  const auto elements = mesh.elements();
  const auto core = mesh.core_z();
  const double gauss_points =
      8.0 * static_cast<double>(elements[0] * elements[1] * (core[1] - core[0]));
  const double bytes = states_per_solution(input) * 6 * sizeof(double) * gauss_points;
  const double memory =
      std::max(least_solution_memory,
               share_of_factorisation * mechanics::factorisation_memory(mesh.unknowns()));
  return std::max<std::size_t>(1, static_cast<std::size_t>(memory / bytes));
}

/// How the entries of a group are solved.
struct GroupPlan {
  std::size_t batch = 1;                    ///< entries at once
  std::optional<mesh::Footprint> footprint; ///< of all of them; empty: each finds its own
};

/// Without a footprint that all can share each entry is tried alone, and says so by itself where
/// the contact leaves the skin.
GroupPlan plan_group(const Case& input, int threads) {
  GroupPlan plan;
  failure_of([&] {
    const auto footprint = mechanics::find_common_footprint(input, input.contact.friction, threads);
    if (footprint) {
      plan = {batch_size(input, *footprint), footprint};
    }
  });
  return plan;
}

/// Study 1 of one point that a finished point shares, read from that point's folder.
bool take_over(const std::vector<SweepPoint>& points, const RunOptions& options, std::size_t donor,
               std::size_t receiver) {
  const auto record =
      read_mechanics(point_options(options, points[donor]).folder / results::file_names::results,
                     mechanics_hash(points[donor].input), points[donor].input.skin);
  if (!record) {
    return false;
  }
  RunFolder folder(points[receiver].input, point_options(options, points[receiver]));
  return folder.stage("strain", [&] {
    write_mechanics(folder.own(results::file_names::results),
                    mechanics_hash(points[receiver].input), *record);
    return true;
  });
}

/// Leaves a solution in the folders of all points that share it, and in the cache.
void leave_in_folders(const std::vector<SweepPoint>& points, const SharedMechanics& shared,
                      const SolvedMechanics& solved, double seconds, const RunOptions& options,
                      base::DiskCache* cache) {
  const Case& input = points[shared.points.front()].input;
  std::optional<std::filesystem::path> first;
  for (const std::size_t i : shared.points) {
    RunFolder folder(points[i].input, point_options(options, points[i]));
    folder.add_finished("mechanics", first ? 0.0 : seconds);
    folder.stage("strain", [&] {
      const auto path = folder.own(results::file_names::results);
      if (first) {
        base::PendingFile pending(path);
        std::filesystem::copy_file(*first, pending.path(),
                                   std::filesystem::copy_options::overwrite_existing);
        pending.commit();
      } else {
        write_mechanics(path, mechanics_hash(input), record_mechanics(input, solved));
        if (cache != nullptr) {
          keep_mechanics(*cache, mechanics_hash(input), path);
        }
        first = path;
      }
      return true;
    });
  }
}

/// Of the mechanics, of which the footprint and the coarser mesh come first.
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
  /// @param cache of the user; none when null
  SharedMechanicsSolver(const std::vector<SweepPoint>& points, const RunOptions& options,
                        base::Timers& timers, std::size_t units, base::DiskCache* cache)
      : points_(points), options_(options), timers_(timers), units_(units), cache_(cache) {}

  /// Solves entries [begin, end) of a group together.
  /// @param footprint of all of them, or empty to find it
  void solve(const FrictionGroup& group, std::size_t begin, std::size_t end,
             const std::optional<mesh::Footprint>& footprint) {
    const double start = base::wall_time();
    std::vector<SolvedMechanics> solutions;
    const auto reason =
        failure_of([&] { solutions = solve_together(group, begin, end, footprint); });
    if (!reason) {
      const double seconds = (base::wall_time() - start) / static_cast<double>(end - begin);
      leave(group, begin, std::move(solutions), seconds);
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
  std::vector<SolvedMechanics> solve_together(const FrictionGroup& group, std::size_t begin,
                                              std::size_t end,
                                              const std::optional<mesh::Footprint>& footprint) {
    const double before = static_cast<double>(finished_) / static_cast<double>(units_);
    const double share = static_cast<double>(end - begin) / static_cast<double>(units_);
    mechanics::ContactOptions contact_options;
    contact_options.threads = options_.threads;
    contact_options.cache = cache_;
    contact_options.footprint = footprint;
    contact_options.progress = [&](std::string_view activity, double fraction) {
      options_.progress("mechanics of all points",
                        before + share * finished_share(activity, fraction));
    };
    std::vector<double> frictions;
    for (std::size_t i = begin; i < end; ++i) {
      frictions.push_back(group[i].friction);
    }
    auto solutions = solve_mechanics(points_[group[begin].points.front()].input, frictions,
                                     contact_options, timers_);
    if (cache_ != nullptr) {
      const std::vector<std::string> notes = cache_->take_notes();
      noted_ = noted_ || !notes.empty();
      for (auto& solution : solutions) {
        std::vector<std::string>& warnings = solution.contact.warnings;
        warnings.insert(warnings.end(), notes.begin(), notes.end());
      }
    }
    return solutions;
  }

  void leave(const FrictionGroup& group, std::size_t begin, std::vector<SolvedMechanics> solutions,
             double seconds) {
    // A warning of the cache, which the results would keep, is no property of the case.
    base::DiskCache* cache = noted_ ? nullptr : cache_;
    parallel::run_tasks(solutions.size(), options_.threads, [&](std::size_t i) {
      const auto solved = std::make_unique<SolvedMechanics>(std::move(solutions[i]));
      leave_in_folders(points_, group[begin + i], *solved, seconds, options_, cache);
    });
  }

  const std::vector<SweepPoint>& points_;
  const RunOptions& options_;
  base::Timers& timers_;
  std::size_t units_, finished_ = 0;
  base::DiskCache* cache_;
  bool noted_ = false; ///< whether the cache had something to say
};

bool has_mechanics(const SweepPoint& point, const RunOptions& options) {
  const auto folder = point_options(options, point).folder;
  const auto path = folder / results::file_names::results;
  if (base::check_seal(path) != base::SealState::whole) {
    return false;
  }
  const results::Hdf5File file(path, results::Hdf5File::Access::read);
  return file.has("/path") &&
         file.text_attribute("/path", "mechanics_hash") == mechanics_hash(point.input);
}

} // namespace

std::vector<MechanicsGroup> mechanics_groups(const std::vector<SweepPoint>& points) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].input.strain.kind == StrainSourceKind::contact) {
      chosen.push_back(i);
    }
  }
  std::vector<MechanicsGroup> result;
  for (const FrictionGroup& group : group_points(points, chosen)) {
    result.push_back({group.front().points.front(), group.size()});
  }
  return result;
}

SweepFailures solve_shared_mechanics(const std::vector<SweepPoint>& points,
                                     const std::vector<std::size_t>& unfinished,
                                     const RunOptions& options, base::Timers& timers) {
  std::map<std::string, std::size_t> donors;
  std::vector<std::size_t> lacking;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].input.strain.kind != StrainSourceKind::contact) {
      continue;
    }
    if (has_mechanics(points[i], options)) {
      donors.emplace(mechanics_hash(points[i].input), i);
    } else if (std::find(unfinished.begin(), unfinished.end(), i) != unfinished.end()) {
      lacking.push_back(i);
    }
  }
  const std::unique_ptr<base::DiskCache> cache = open_user_cache(options);
  std::vector<std::size_t> to_solve;
  for (const std::size_t i : lacking) {
    const std::string hash = mechanics_hash(points[i].input);
    const auto donor = donors.find(hash);
    const bool taken_over = donor != donors.end() && take_over(points, options, donor->second, i);
    const bool kept = cache && keeps_mechanics(*cache, hash);
    if (!taken_over && !kept) { // run_case finds what is kept
      to_solve.push_back(i);
    }
  }
  const std::vector<FrictionGroup> groups = group_points(points, to_solve);
  std::size_t units = 0;
  for (const FrictionGroup& group : groups) {
    units += group.size();
  }
  if (units > 0) {
    options.progress("mechanics of all points", 0.0);
  }
  SharedMechanicsSolver solver(points, options, timers, units, cache.get());
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
