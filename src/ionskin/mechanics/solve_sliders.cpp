// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_sliders.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/path_resolution.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr int most_passes = 12; ///< largest number of passes over all sliders
/// Share of the remaining progress that one pass takes [1]; a few passes are usual.
constexpr double share_of_pass = 0.4;

/// Throws UserError unless all sliders follow rigid paths without adhesion and have cycles of one
/// duration.
void require_together(const std::vector<Case>& sliders) {
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const Case& one = sliders[i];
    if (one.motion.drive.given() ||
        laws::friction(one.contact.law, one.contact.friction, one.contact.parameters)
            .adhesion.pulls()) {
      throw UserError(fmt::format("slider {} of {} {}\n  = several sliders on one skin go along "
                                  "rigid paths and do not adhere",
                                  i + 1, sliders.size(),
                                  one.motion.drive.given() ? "hangs on a drive" : "adheres"));
    }
    const double duration = one.motion.cycle_duration(),
                 first = sliders.front().motion.cycle_duration();
    if (std::abs(duration - first) > 1e-9 * first) {
      throw UserError(fmt::format("the cycle of slider {} lasts {:.6g} s, that of slider 1 {:.6g} "
                                  "s\n  = several sliders on one skin need cycles of one duration",
                                  i + 1, duration, first));
    }
  }
}

/// Position of a slider at a time, and whether the slider may touch the skin.
struct Whereabouts {
  std::array<double, 2> centre{};
  bool touches = false;
};

Whereabouts whereabouts(const std::vector<MotionLeg>& legs, double time) {
  const auto leg = std::ranges::find_if(legs, [&](const auto& one) { return time <= one.end(); });
  const MotionLeg& at = leg == legs.end() ? legs.back() : *leg;
  return {at.centre(std::clamp(time - at.begin, 0.0, at.duration)), at.touches()};
}

/// Smallest distance between the footprints of two sliders while both may touch [m]. Searches each
/// interval between instants at which legs end: within it both sliders move at constant velocity,
/// and the distance of two rectangles is a convex function of their relative position.
double least_distance(const std::vector<MotionLeg>& one, const mesh::Footprint& of_one,
                      const std::vector<MotionLeg>& other, const mesh::Footprint& of_other) {
  std::vector<double> instants{0};
  for (const auto* legs : {&one, &other}) {
    for (const MotionLeg& leg : *legs) {
      instants.push_back(leg.end());
    }
  }
  std::ranges::sort(instants);
  double least = std::numeric_limits<double>::infinity();
  const auto apart = [&](double time) {
    return distance(whereabouts(one, time).centre, of_one.half_size,
                    whereabouts(other, time).centre, of_other.half_size);
  };
  for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
    double from = instants[i], to = instants[i + 1];
    const double middle = 0.5 * (from + to);
    if (!whereabouts(one, middle).touches || !whereabouts(other, middle).touches) {
      continue;
    }
    constexpr int thirds = 100;
    for (int k = 0; k < thirds; ++k) {
      const double third = (to - from) / 3;
      (apart(from + third) < apart(to - third) ? to : from) =
          apart(from + third) < apart(to - third) ? to - third : from + third;
    }
    least = std::min(least, apart(0.5 * (from + to)));
  }
  return least;
}

/// Throws UserError where two sliders come nearer to each other than the short waves reach.
void require_apart(const std::vector<Case>& sliders,
                   const std::vector<mesh::Footprint>& footprints) {
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const auto box = contact_box(sliders[i]);
    if (!box) {
      continue;
    }
    const double reach = skin_waves(sliders[i].skin, footprints[i], *box).reach;
    const auto legs = motion_legs(sliders[i].motion, sliders[i].slider);
    for (std::size_t j = 0; j < sliders.size(); ++j) {
      if (i == j) {
        continue;
      }
      const double apart = least_distance(
          legs, footprints[i], motion_legs(sliders[j].motion, sliders[j].slider), footprints[j]);
      if (apart < reach) {
        throw UserError(
            fmt::format("sliders {} and {} come within {:.4g} mm of each other\n  = keep the areas "
                        "that they may touch {:.4g} mm apart: nearer, the local deformations under "
                        "both overlap, which is not solved",
                        std::min(i, j) + 1, std::max(i, j) + 1, 1e3 * apart, 1e3 * reach));
      }
    }
  }
}

/// True if all sliders press on the middle of the width, so that half of the skin can be modelled.
bool all_on_middle(const std::vector<Case>& sliders,
                   const std::vector<mesh::Footprint>& footprints) {
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    if (!mesh::SkinMesh(sliders[i], footprints[i]).half_model()) {
      return false;
    }
  }
  return true;
}

} // namespace

void require_sliders_apart(const std::vector<Case>& sliders) {
  std::vector<mesh::Footprint> footprints;
  for (const Case& one : sliders) {
    footprints.push_back(one.slider.sharp() ? mesh::largest_footprint(one) : mesh::Footprint{});
  }
  require_apart(sliders, footprints);
}

std::vector<ContactSolution> solve_sliders(const std::vector<Case>& sliders,
                                           const ContactOptions& options, base::Timers& timers) {
  require_together(sliders);
  std::vector<mesh::Footprint> footprints;
  for (const Case& one : sliders) {
    footprints.push_back(
        find_footprint(one, one.contact.friction, options.threads, options.progress).footprint);
  }
  require_apart(sliders, footprints);
  ContactOptions own = options;
  // Half of the skin suffices where all sliders press on its middle.
  own.full_model = options.full_model || !all_on_middle(sliders, footprints);
  own.unfinished = nullptr; // the path of a single slider is no result
  const double resolution = path_resolution(sliders.front().numerics),
               tolerance = resolution * resolution;
  const auto count = static_cast<double>(sliders.size());
  std::vector<ContactSolution> solutions;
  std::vector<ForcePath> paths;
  double change = 0, done = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    change = 0;
    const double share = share_of_pass * (1 - done);
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      base::check_interrupt();
      const double before = done + share * static_cast<double>(i) / count;
      own.progress = [&, before](std::string_view activity, double fraction) {
        options.progress(activity, before + share * fraction / count);
      };
      auto others = std::make_shared<std::vector<ForcePath>>();
      for (std::size_t j = 0; j < paths.size(); ++j) {
        if (j != i) {
          others->push_back(paths[j]);
        }
      }
      own.footprint = footprints[i];
      ContactSolution solution = std::move(
          solve_variants(sliders[i], {{sliders[i].contact.friction, options.steps, others}}, own,
                         timers)
              .front());
      ForcePath path = force_path(solution);
      if (pass == 0) {
        solutions.push_back(std::move(solution));
        paths.push_back(std::move(path));
        continue;
      }
      change = std::max(change, change_of_forces(path, paths[i]));
      solutions[i] = std::move(solution);
      paths[i] = std::move(path);
    }
    done += share;
    if (sliders.size() == 1 || (pass > 0 && change <= tolerance)) {
      options.progress("mechanics", 1.0);
      return solutions;
    }
  }
  throw SolverError(fmt::format("after {} passes the forces of {} sliders on one skin still change "
                                "by {:.3g} of the largest",
                                most_passes, sliders.size(), change),
                    "move the sliders farther apart, or lower numerics.time_refinement");
}

} // namespace ionskin::mechanics
