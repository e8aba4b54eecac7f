// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/sliders/sliders_history.hpp"

#include "ionskin/handover/handover.hpp"
#include "ionskin/handover/sliders/fixed_grid.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::handover {
namespace {

/// A slider beside the middle of the width, so that the whole skin is meshed.
Case aside(double start_x) {
  Case input = small_case();
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {start_x, 0.9e-3};
  input.motion.stroke = 1e-3;
  return input;
}

double middle(const std::vector<double>& lines, std::size_t half) {
  const double low = lines[half / 2], high = lines[half / 2 + 1];
  return low + (half % 2 == 0 ? 0.25 : 0.75) * (high - low);
}

/// A shear e_xz that is linear in x and y, of the slider's own size, and the same at all heights.
mechanics::SharedState linear_state(const mechanics::ContactSolution& contact,
                                    const std::array<double, 2>& centre, double amplitude) {
  mechanics::ContactState state = synthetic_state(contact.mesh, amplitude);
  const auto lines = contact.mesh.lines(centre);
  const auto [nx, ny, nz] = state.strain.points;
  for (auto& component : state.strain.component) {
    std::ranges::fill(component, 0.0);
  }
  for (std::size_t k = 0; k < nz; ++k) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        state.strain.component[4][(k * ny + j) * nx + i] =
            1e-3 * amplitude * (1 + 30 * middle(lines.x, i) + 50 * middle(lines.y, j));
      }
    }
  }
  return std::make_shared<const mechanics::ContactState>(std::move(state));
}

/// Contact of a slider that rests from touchdown on.
mechanics::ContactSolution resting(const Case& input, double amplitude) {
  mechanics::ContactSolution contact{mesh::SkinMesh(input)};
  const auto state = linear_state(contact, input.slider.start, amplitude);
  for (const double time : {0.0, 0.5, 4.0}) {
    contact.stepped.push_back({time, input.slider.start, -1e-6, state});
  }
  contact.stepped_events = {0.5};
  return contact;
}

TEST(SlidersHistory, KeepsTheIntegralThatRidingCellsHave) {
  const Case input = aside(4.5e-3);
  const mechanics::ContactSolution contact = synthetic_contact(input);
  const auto fixed = build_sliders_history({input}, {contact});
  const auto riding = build_strain_history(input, contact);
  EXPECT_EQ(fixed.frame, history::Frame::skin);
  EXPECT_EQ(fixed.time.back(), riding.time.back());
  const ContactTimeline timeline(input, contact);
  for (const double time : timeline.sample_times()) {
    const double expected = mechanics_shear_integral(input, contact.mesh, timeline.at(time));
    EXPECT_NEAR(history::shear_integral(fixed, time), expected, 1e-9 * std::abs(expected))
        << "at " << time;
  }
}

TEST(SlidersHistory, MirrorsHalfOfTheSkin) {
  const Case input = small_case();
  const mechanics::ContactSolution contact = synthetic_contact(input);
  ASSERT_TRUE(contact.mesh.half_model());
  const auto history = build_sliders_history({input}, {contact});
  const history::StrainGrid& grid = history.grid;
  EXPECT_EQ(grid.y_edges.back(), input.skin.width);
  const ContactTimeline timeline(input, contact);
  const double time = timeline.sample_times()[6];
  const double expected = mechanics_shear_integral(input, contact.mesh, timeline.at(time));
  EXPECT_NEAR(history::shear_integral(history, time), expected, 1e-9 * std::abs(expected));
  const auto& field = *history.shear()[history.shear().size() / 4];
  const std::size_t nx = grid.columns_x(), ny = grid.columns_y();
  for (std::size_t j = 0; j < ny; ++j) {
    EXPECT_EQ(field[j * nx + nx / 2], field[(ny - 1 - j) * nx + nx / 2]) << j;
  }
}

TEST(SlidersHistory, AddsUpTheStrainsOfAllSliders) {
  const Case one = aside(4e-3), other = aside(11e-3);
  const auto alone = build_sliders_history({one}, {resting(one, 1)});
  const auto both = build_sliders_history({one, other}, {resting(one, 1), resting(other, 2)});
  EXPECT_NEAR(history::shear_integral(both, 2), 3 * history::shear_integral(alone, 2),
              1e-9 * history::shear_integral(both, 2));
  // Near either slider, whose meshes differ.
  const auto& field = *both.shear().back();
  const auto& grid = both.grid;
  for (std::size_t j = 0; j < grid.columns_y(); ++j) {
    for (std::size_t i = 0; i < grid.columns_x(); ++i) {
      const double x = 0.5 * (grid.x_edges[i] + grid.x_edges[i + 1]),
                   y = 0.5 * (grid.y_edges[j] + grid.y_edges[j + 1]);
      const double expected = 2 * 3e-3 * (1 + 30 * x + 50 * y);
      ASSERT_NEAR(field[j * grid.columns_x() + i], expected, 1e-9) << x << " " << y;
    }
  }
}

TEST(SlidersHistory, SamplesBeforeASliderIsACellFarther) {
  const Case input = aside(4.5e-3);
  const auto history = build_sliders_history(
      {input, aside(10e-3)}, {synthetic_contact(input), synthetic_contact(aside(10e-3))});
  const double speed = input.motion.stroke / input.motion.slide;
  double longest = 0;
  for (std::size_t i = 1; i < history.time.size(); ++i) {
    if (history.time[i] > 0.5 && history.time[i] <= 2.5) {
      longest = std::max(longest, history.time[i] - history.time[i - 1]);
    }
  }
  EXPECT_LE(longest * speed, 1.001 * fixed_cell_width(input));
  EXPECT_GT(longest * speed, 0.3 * fixed_cell_width(input));
  for (const double event : history.event_time) {
    EXPECT_TRUE(std::ranges::binary_search(history.time, event)) << event;
  }
}

TEST(FixedGrid, IsEvenWhereASliderMayTouch) {
  const Case one = aside(4e-3), other = aside(11e-3);
  const mesh::SkinMesh mesh(one), other_mesh(other);
  const CoreGrid grid = fixed_core_grid({one, other}, {&mesh, &other_mesh});
  EXPECT_EQ(grid.x_edges.front(), 0);
  EXPECT_EQ(grid.x_edges.back(), one.skin.length);
  const double width = fixed_cell_width(one);
  double widest = 0;
  for (std::size_t i = 0; i + 1 < grid.x_edges.size(); ++i) {
    const double cell = grid.x_edges[i + 1] - grid.x_edges[i];
    const double x = 0.5 * (grid.x_edges[i] + grid.x_edges[i + 1]);
    EXPECT_GT(cell, 0);
    widest = std::max(widest, cell);
    const bool under = (x > 3.6e-3 && x < 5.4e-3) || (x > 10.6e-3 && x < 12.4e-3);
    EXPECT_LE(cell, under ? 1.001 * width : 1.001 * outer_cell_limit(one.skin)) << x;
  }
  EXPECT_GT(widest, 1.5 * width) << "beside them cells grow";
}

} // namespace
} // namespace ionskin::handover
