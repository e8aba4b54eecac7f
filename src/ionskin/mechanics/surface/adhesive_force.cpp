// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/adhesive_force.hpp"

#include "ionskin/base/error.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ionskin::mechanics {
namespace {

constexpr int most_heights = 200;        ///< largest number of heights that are tried
constexpr double first_way = 0.25;       ///< first change of height over the range of adhesion [1]
constexpr double longest_way_growth = 2; ///< largest ratio of successive changes of height [1]
constexpr double beyond_need = 1.05;     ///< change of height over its linear extrapolation [1]
/// Shortest way up, over the range of adhesion [1]: if the slider comes off within it, it does so
/// in a jump.
constexpr double shortest_way = 1e-4;
constexpr double balance_tolerance = 1e-10; ///< error of the force over the sum of magnitudes [1]
constexpr double height_tolerance = 1e-18;  ///< width of the final bracket of the height [m]

/// Searches for the height of the slider at which an adhesive contact carries a given force.
class ForceSearch {
public:
  ForceSearch(const ContactProblem& problem, const SliderStep& step)
      : problem_(problem), step_(step), range_(problem.friction.adhesion.range) {}

  /// Searches from a start, up or down, until two heights enclose the force.
  SurfaceState from(const AdhesiveStart& start) const {
    SurfaceState here = at(start.indentation, start);
    const double side = excess(here) > 0 ? -1 : 1; // up where it presses too hard
    double way = first_way * range_;
    for (int i = 0; i < most_heights; ++i) {
      SurfaceState next = at(here.indentation + side * way, start_from(problem_, here));
      if (side < 0 && sum_of_magnitudes(next.force) == 0) {
        if (way <= shortest_way * range_) {
          return next; // the slider comes off before it pulls with the given force
        }
        way /= 2;
        continue;
      }
      if (excess(next) * excess(here) <= 0) {
        return between(std::move(here), std::move(next));
      }
      const double slope = (excess(next) - excess(here)) / (side * way);
      const double left = slope > 0 ? std::abs(excess(next)) / slope : longest_way_growth * way;
      way = std::min(longest_way_growth * way, std::max(beyond_need * left, shortest_way * range_));
      here = std::move(next);
    }
    throw SolverError(fmt::format("the adhesive contact carries {:.3g} N at no height that was "
                                  "tried",
                                  step_.load.value),
                      "give heights in place of forces");
  }

private:
  /// Normal force of a state minus the given force [N].
  double excess(const SurfaceState& state) const {
    return total_normal_force(state.force) - step_.load.value;
  }
  /// Solves at a held indentation [m].
  SurfaceState at(double indentation, const AdhesiveStart& start) const {
    SliderStep step = step_;
    step.load = {LoadKind::indentation, indentation};
    auto near = nearby_solution(problem_, step, start.force, indentation);
    return near ? *std::move(near) : relaxed_contact(problem_, step, start);
  }
  /// Finds the state that carries the force between two states that enclose it, by Newton's method
  /// from the nearer one or by a bracketed search over the indentation.
  SurfaceState between(SurfaceState near, SurfaceState far) const {
    const double low = std::min(near.indentation, far.indentation),
                 high = std::max(near.indentation, far.indentation);
    if (auto found = nearby_solution(problem_, step_, near.force, near.indentation);
        found && found->indentation >= low && found->indentation <= high) {
      return *std::move(found);
    }
    const double sign = excess(near);
    SurfaceState last = far;
    const auto left = [&](double indentation) {
      last = at(indentation, start_from(problem_, near));
      const double off = excess(last);
      if (std::abs(off) <= balance_tolerance * sum_of_magnitudes(last.force)) {
        return 0.0;
      }
      if (off * sign > 0) {
        near = last;
      }
      return off;
    };
    const double at_low = low == far.indentation ? excess(far) : sign,
                 at_high = low == far.indentation ? sign : excess(far);
    std::uintmax_t heights = most_heights;
    boost::math::tools::toms748_solve(
        left, low, high, at_low, at_high,
        [](double a, double b) { return std::abs(b - a) < height_tolerance; }, heights);
    last.step = step_;
    return last;
  }

  const ContactProblem& problem_;
  const SliderStep& step_;
  double range_;
};

} // namespace

SurfaceState adhesive_contact_at_force(const ContactProblem& problem, const SliderStep& step,
                                       const AdhesiveStart& start) {
  return ForceSearch(problem, step).from(start);
}

} // namespace ionskin::mechanics
