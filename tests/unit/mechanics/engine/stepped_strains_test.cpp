// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include "condensed_line.hpp"
#include "largest_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace ionskin::mechanics {
namespace {

constexpr std::size_t states = 60; // of more than one block

/// A slide along the small case's line.
std::shared_ptr<SteppedStrains> slide(const std::shared_ptr<SharedRecovery>& recovery,
                                      double friction) {
  auto path = std::make_shared<SteppedStrains>(recovery);
  for (std::size_t k = 0; k < states; ++k) {
    const double part = static_cast<double>(k) / (states - 1);
    CellVector force(3 * line().model->cells.count(), 0.0);
    for (std::size_t i = 0; i < force.size(); i += 3) {
      force[i] = 1 + part * static_cast<double>(i) / static_cast<double>(force.size());
      force[i + 1] = friction * force[i];
    }
    path->add({1.5e-3 + 2e-3 * part, 1e-3}, std::move(force));
  }
  return path;
}

/// @param positions as in NodeOptions
std::shared_ptr<const PositionNodes> nodes_of(std::size_t positions) {
  const base::ProgressCallback none = base::no_progress;
  parallel::SharedProgress progress("mechanics", none);
  NodeOptions options{.threads = 2, .cache = nullptr, .count = 2};
  options.positions = positions;
  return std::make_shared<const PositionNodes>(
      line().input, line().model, MotionBox{{1.5e-3, 1e-3}, {3.5e-3, 1e-3}}, options, progress);
}

std::shared_ptr<SharedRecovery> recovery_from_factors() {
  static const auto nodes = nodes_of(1'000'000);
  return std::make_shared<SharedRecovery>(nodes);
}

TEST(SteppedStrains, FromFactorsAreThoseFromResponses) {
  const auto factors = recovery_from_factors(),
             responses = std::make_shared<SharedRecovery>(nodes_of(1));
  ASSERT_TRUE(factors->nodes().holds_factors());
  ASSERT_FALSE(responses->nodes().holds_factors());
  const auto path = slide(factors, 0.3), expected = slide(responses, 0.3);
  for (std::size_t k = 0; k < states; ++k) {
    EXPECT_LT(largest_difference(path->at(k).component[4], expected->at(k).component[4]), 1e-7)
        << k;
  }
  EXPECT_LT(
      largest_difference(path->largest_electrode_stress(), expected->largest_electrode_stress()),
      1e-6);
  EXPECT_LT(path->worst_equilibrium_residual(), 1e-9);
}

TEST(SteppedStrains, FromFactorsAreRecoveredForAllPathsTogetherAndTheSameForEach) {
  const auto factors = recovery_from_factors();
  const auto one = slide(factors, 0.3), other = slide(factors, 0.1);
  factors->join(one);
  factors->join(other);
  std::size_t positions = 0;
  factors->begin([&] { ++positions; });
  EXPECT_EQ(positions, factors->nodes().places());
  const auto alone = slide(factors, 0.1); // did not join
  for (const std::size_t k : {std::size_t{0}, states - 1, std::size_t{7}}) {
    EXPECT_EQ(other->at(k).component, alone->at(k).component) << k;
    EXPECT_NE(other->at(k).component, one->at(k).component) << k;
  }
}

} // namespace
} // namespace ionskin::mechanics
