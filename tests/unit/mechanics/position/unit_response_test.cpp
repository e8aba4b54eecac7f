// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/unit_response.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;
using linear_algebra::FixedPointMatrix;

template <class T> void expect_same_bits(const std::vector<T>& read, const std::vector<T>& given) {
  ASSERT_EQ(read.size(), given.size());
  EXPECT_EQ(std::memcmp(read.data(), given.data(), given.size() * sizeof(T)), 0);
}

TEST(UnitResponse, what_a_position_gives_is_read_back_to_the_last_bit) {
  constexpr int cells = 2, core_rows = 5, membrane_rows = 3;
  StoredPosition given{DenseMatrix(3 * cells, 3 * cells), {}};
  for (std::size_t i = 0; i < given.compliance.values.size(); ++i) {
    given.compliance.values[i] = std::exp(-20.0 * std::sin(static_cast<double>(i)));
  }
  given.compliance.values[1] = -0.0;
  given.compliance.values[2] = std::numeric_limits<double>::denorm_min();
  for (const std::size_t d : {0u, 2u}) { // no force was asked for along x
    DirectionResponse& response = given.response[d].emplace(
        DirectionResponse{FixedPointMatrix(core_rows, cells),
                          FixedPointMatrix(membrane_rows, cells), DenseMatrix(3, cells)});
    for (int j = 0; j < cells; ++j) {
      const double column[] = {0.1 + j, -1.0 / 3, 1e-9, 0, 7};
      response.core.set_column(j, column);
      response.membrane.set_column(j, column);
    }
    response.base_reaction.values.assign(response.base_reaction.values.size(), -1.0 / 7);
  }
  const results::ScratchFolder folder;
  base::DiskCache cache(folder.path(), 1'000'000);
  const base::Digest key = base::DigestBuilder().add("a position").finish();
  write_position(cache, key, given, least_positions);
  const auto read = read_position(cache, key, core_rows, membrane_rows, cells);
  ASSERT_TRUE(read);
  expect_same_bits(read->compliance.values, given.compliance.values);
  ASSERT_FALSE(read->response[1].has_value());
  for (const std::size_t d : {0u, 2u}) {
    ASSERT_TRUE(read->response[d].has_value());
    expect_same_bits(read->response[d]->core.unit, given.response[d]->core.unit);
    expect_same_bits(read->response[d]->core.values, given.response[d]->core.values);
    expect_same_bits(read->response[d]->membrane.unit, given.response[d]->membrane.unit);
    expect_same_bits(read->response[d]->membrane.values, given.response[d]->membrane.values);
    expect_same_bits(read->response[d]->base_reaction.values,
                     given.response[d]->base_reaction.values);
  }
  // Of another mesh it is none.
  EXPECT_FALSE(read_position(cache, key, core_rows + 1, membrane_rows, cells));
}

TEST(UnitResponse, is_kept_where_all_positions_of_a_path_have_room) {
  constexpr int cells = 2, core_rows = 5, membrane_rows = 3;
  StoredPosition given{DenseMatrix(3 * cells, 3 * cells), {}};
  given.response[0].emplace(DirectionResponse{FixedPointMatrix(core_rows, cells),
                                              FixedPointMatrix(membrane_rows, cells),
                                              DenseMatrix(3, cells)});
  const results::ScratchFolder folder;
  base::DiskCache cache(folder.path(), 10'000); // an entry takes a few hundred bytes
  const base::Digest key = base::DigestBuilder().add("a position").finish();
  const auto kept = [&](std::size_t positions) {
    write_position(cache, key, given, positions);
    return cache.clear().entries == 1;
  };
  EXPECT_TRUE(kept(1));
  EXPECT_TRUE(kept(24));
  EXPECT_FALSE(kept(240));
}

} // namespace
} // namespace ionskin::mechanics
