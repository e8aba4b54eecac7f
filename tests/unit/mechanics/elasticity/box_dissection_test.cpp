// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/box_dissection.hpp"

#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/linear_algebra/postorder.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr std::array<std::array<BoxFace, 2>, 3> all_open{};

TEST(BoxDissection, lists_every_node_once_but_those_of_held_and_later_faces) {
  const auto order = dissection_order({3, 2, 4}, {{{BoxFace::open, BoxFace::later},
                                                   {BoxFace::open, BoxFace::open},
                                                   {BoxFace::held, BoxFace::open}}});
  const std::set<int> nodes(order.begin(), order.end());
  EXPECT_EQ(nodes.size(), order.size());
  EXPECT_EQ(nodes.size(), std::size_t{6 * 5 * 8});
  for (const int node : nodes) {
    EXPECT_LT(node % 7, 6);
    EXPECT_GE(node / (7 * 5), 1);
  }
}

TEST(BoxDissection, of_a_cube_ends_with_a_plane_between_elements_near_its_middle) {
  const auto order = dissection_order({8, 8, 8}, all_open);
  const std::size_t n = 17, size = n * n;
  ASSERT_EQ(order.size(), n * size);
  std::array<std::set<int>, 3> last;
  for (const int node : std::span(order).last(size)) {
    last[0].insert(node % 17);
    last[1].insert(node / 17 % 17);
    last[2].insert(node / 289);
  }
  const auto plane = std::ranges::find(last, std::size_t{1}, &std::set<int>::size);
  ASSERT_NE(plane, last.end());
  EXPECT_EQ(*plane->begin() % 2, 0);
  EXPECT_NEAR(*plane->begin(), 8, 2);
}

TEST(BoxDissection, takes_far_fewer_operations_than_node_by_node) {
  const std::size_t n = 8;
  mesh::MeshLines lines;
  for (std::vector<double>* line : {&lines.x, &lines.y, &lines.z}) {
    line->resize(n + 1);
    std::iota(line->begin(), line->end(), 0.0);
  }
  const ElasticSpace space(lines, {{"base", Face::base, {true, true, true}}});
  const auto operations = [&](const std::vector<int>& order) {
    return linear_algebra::SymbolicCholesky(space.pattern(), order, 0).operations();
  };
  std::vector<int> by_number(static_cast<std::size_t>(space.unknowns()));
  std::iota(by_number.begin(), by_number.end(), 0);
  const auto postordered = linear_algebra::postordered(space.pattern(), by_number, 0);
  EXPECT_LT(operations(space.elimination_order({})), 0.5 * operations(postordered));
}

} // namespace
} // namespace ionskin::mechanics
