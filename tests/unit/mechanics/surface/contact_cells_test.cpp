// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ionskin::mechanics {
namespace {

TEST(ContactCells, FillTheFootprint) {
  const ContactCells cells = contact_cells(mesh::SkinMesh(small_case()));
  EXPECT_EQ(cells.count(), cells.columns() * cells.rows());
  EXPECT_NEAR(std::accumulate(cells.area.begin(), cells.area.end(), 0.0), 1e-3 * 0.4e-3, 1e-18);
}

} // namespace
} // namespace ionskin::mechanics
