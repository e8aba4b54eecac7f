// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ionskin::mechanics {
namespace {

TEST(ContactCells, areas_fill_the_footprint_and_unit_loads_sum_to_one) {
  const Case input = small_case();
  const mesh::SkinMesh mesh(input);
  const ElasticSpace space(mesh.lines(input.slider.start), skin_boundary(input.skin, true));
  const ContactCells cells = contact_cells(mesh, space);
  EXPECT_NEAR(std::accumulate(cells.area.begin(), cells.area.end(), 0.0), 1e-3 * 0.4e-3, 1e-18);
  for (int cell = 0; cell < static_cast<int>(cells.count()); ++cell) {
    const double* normal = cells.unit_load.column(3 * cell);
    const double* along = cells.unit_load.column(3 * cell + 1);
    EXPECT_NEAR(std::accumulate(normal, normal + cells.unit_load.rows, 0.0), -1, 1e-14);
    EXPECT_NEAR(std::accumulate(along, along + cells.unit_load.rows, 0.0), 1, 1e-14);
  }
}

} // namespace
} // namespace ionskin::mechanics
