// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/condensed_position.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "largest_difference.hpp"
#include "scratch_folder.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

namespace ionskin::mechanics {
namespace {

class CondensedPositionTest : public testing::Test {
protected:
  CondensedPosition position(base::DiskCache* cache, const ForceDirections& forces,
                             std::size_t positions = least_positions) const {
    return {model_, input_.slider.start, {cache, forces, positions}};
  }
  /// Forces without a direction across x, each different.
  CellVector forces(double first) const {
    CellVector result(3 * model_.cells.count());
    for (std::size_t at = 0; at < result.size(); ++at) {
      result[at] = at % 3 == 2 ? 0 : std::cos(first + static_cast<double>(at));
    }
    return result;
  }
  static constexpr ForceDirections all{true, true, true}, along_x{true, true, false};
  results::ScratchFolder folder_;

private:
  Case input_ = small_case();
  SkinModel model_{input_, find_footprint(input_, input_.contact.friction, 1)};
};

TEST_F(CondensedPositionTest, responds_with_the_same_bits_from_any_cache_and_in_any_company) {
  base::DiskCache cache(folder_.path(), 1'000'000'000);
  const CellVector force = forces(0.3);
  const auto plain = position(nullptr, all).respond({force}).front();
  const auto same = [&](const CondensedPosition::Response& response) {
    EXPECT_EQ(response.core, plain.core);
    EXPECT_EQ(response.electrode_strain, plain.electrode_strain);
    EXPECT_EQ(response.equilibrium_residual, plain.equilibrium_residual);
  };
  EXPECT_FALSE(position(nullptr, all).holds_factor());
  for (const ForceDirections& asked : {along_x, along_x, all, all, along_x}) {
    same(position(&cache, asked).respond({force}).front()); // made, read, made again, read
    same(position(&cache, asked).respond({forces(1), forces(2), force, forces(3)})[2]);
  }
}

TEST_F(CondensedPositionTest, refuses_a_force_that_it_was_not_made_for) {
  CellVector force = forces(0);
  force[2] = 1;
  EXPECT_THROW(position(nullptr, along_x).respond({force}), InternalError);
}

TEST_F(CondensedPositionTest, keeps_no_responses_that_the_cache_has_no_room_for) {
  base::DiskCache cache(folder_.path(), 1'000'000);
  position(&cache, all);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  EXPECT_TRUE(cache.take_notes().empty());
}

TEST_F(CondensedPositionTest, of_a_path_whose_responses_take_too_much_holds_a_factor) {
  base::DiskCache cache(folder_.path(), 1'000'000'000);
  const CondensedPosition by_products = position(nullptr, all),
                          by_factor = position(&cache, all, 1'000'000);
  ASSERT_TRUE(by_factor.holds_factor());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  EXPECT_EQ(by_factor.compliance().values, by_products.compliance().values);
  std::vector<CellVector> many; // more than are recovered at once
  for (int k = 0; k < 40; ++k) {
    many.push_back(forces(k));
  }
  const auto expected = by_products.respond(many), found = by_factor.respond(many);
  for (std::size_t k = 0; k < many.size(); ++k) {
    const CoreStrain strain = by_factor.strain(found[k]),
                     strain_expected = by_products.strain(expected[k]);
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_LT(largest_difference(strain.component[c], strain_expected.component[c]), 1e-6);
    }
    EXPECT_LT(found[k].equilibrium_residual, 1e-9);
  }
}

} // namespace
} // namespace ionskin::mechanics
