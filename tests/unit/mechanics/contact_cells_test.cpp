// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/contact_cells.hpp"

#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ionskin::mechanics {
namespace {

TEST(ContactCells, means_of_shape_functions_are_exact_for_quadratics) {
  // t^2 has the nodal values 0, 1/4, 1; its mean over [a, b] is (b^3 - a^3) / (3 (b - a)).
  for (const auto& [a, b] : {std::pair{0.0, 1.0}, {0.0, 0.5}, {0.5, 1.0}}) {
    const auto mean = mean_shape_values(a, b);
    EXPECT_NEAR(mean[0] + mean[1] + mean[2], 1, 1e-15);
    EXPECT_NEAR(mean[1] / 4 + mean[2], (b * b * b - a * a * a) / (3 * (b - a)), 1e-15);
  }
}

TEST(ContactCells, areas_fill_the_footprint_and_unit_loads_sum_to_one) {
  const Case input = small_case();
  const mesh::SkinMesh mesh(input);
  const ElasticSpace space(mesh.lines(input.slider.start), skin_boundary(input.skin, true));
  for (const int per_element : {1, 2}) {
    const ContactCells cells = contact_cells(mesh, space, per_element);
    EXPECT_NEAR(std::accumulate(cells.area.begin(), cells.area.end(), 0.0), 1e-3 * 0.4e-3, 1e-18);
    for (int cell = 0; cell < static_cast<int>(cells.count()); ++cell) {
      const double* normal = cells.unit_load.column(3 * cell);
      const double* along = cells.unit_load.column(3 * cell + 1);
      EXPECT_NEAR(std::accumulate(normal, normal + cells.unit_load.rows, 0.0), -1, 1e-14);
      EXPECT_NEAR(std::accumulate(along, along + cells.unit_load.rows, 0.0), 1, 1e-14);
    }
  }
}

} // namespace
} // namespace ionskin::mechanics
