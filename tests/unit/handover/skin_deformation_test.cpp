// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/largest.hpp"
#include "ionskin/handover/skin_deformation.hpp"

#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::handover {
namespace {

constexpr double mid_slide = 1.5; // [s]

mechanics::ContactSolution solved(const Case& input, bool whole = false) {
  mechanics::ContactOptions options;
  options.full_model = whole;
  base::Timers timers;
  return mechanics::solve_contact(input, options, timers);
}

SkinDeformation deformation(const Case& input, const mechanics::ContactSolution& contact,
                            double time) {
  const StateCombination at = ContactTimeline(input, contact).at(time);
  return skin_deformation(input.skin, contact.mesh, at,
                          at.terms.empty() ? nullptr
                                           : at.terms.front().state->source->all_layers());
}

std::size_t interval(const std::vector<double>& lines, double at) {
  const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, at);
  return static_cast<std::size_t>(above - lines.begin()) - 1;
}

/// Bilinear on the top face [m].
double on_top(const SkinDeformation& skin, std::size_t component, double x, double y) {
  const std::size_t i = interval(skin.x, x), j = interval(skin.y, y), nx = skin.x.size();
  const double s = (x - skin.x[i]) / (skin.x[i + 1] - skin.x[i]),
               t = (y - skin.y[j]) / (skin.y[j + 1] - skin.y[j]);
  const double* top =
      skin.displacement[component].data() + nx * skin.y.size() * (skin.z.size() - 1);
  return (1 - t) * ((1 - s) * top[i + nx * j] + s * top[i + 1 + nx * j]) +
         t * ((1 - s) * top[i + nx * (j + 1)] + s * top[i + 1 + nx * (j + 1)]);
}

/// Sum of a stress over a row of cells [N].
double force_through(const SkinDeformation& skin, std::size_t component, std::size_t row) {
  double sum = 0;
  const std::size_t nx = skin.x.size() - 1, ny = skin.y.size() - 1;
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      sum += skin.stress[component][i + nx * (j + ny * row)] * (skin.x[i + 1] - skin.x[i]) *
             (skin.y[j + 1] - skin.y[j]);
    }
  }
  return sum;
}

TEST(SkinDeformation, TheTopFaceMovesAsTheContactSays) {
  const Case input = small_case();
  const auto contact = solved(input);
  const StateCombination slide = ContactTimeline(input, contact).at(mid_slide);
  ASSERT_EQ(slide.terms.size(), 1u);
  const mechanics::ContactState& state = *slide.terms.front().state;
  const SkinDeformation skin = deformation(input, contact, mid_slide);
  const std::vector<double>&lines_x = contact.cell_lines_x, &lines_y = contact.cell_lines_y;
  double scale = 0, worst = 0, squares = 0, errors = 0;
  std::size_t cell = 0;
  for (std::size_t j = 0; j + 1 < lines_y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lines_x.size(); ++i, ++cell) {
      const double x = slide.centre[0] + 0.5 * (lines_x[i] + lines_x[i + 1]),
                   y = slide.centre[1] + 0.5 * (lines_y[j] + lines_y[j + 1]);
      const std::array<double, 3> expected{state.surface[3 * cell + 1], state.surface[3 * cell + 2],
                                           -state.surface[3 * cell]};
      for (std::size_t c = 0; c < 3; ++c) {
        const double error = on_top(skin, c, x, y) - expected[c];
        scale = std::max(scale, std::abs(expected[c]));
        squares += expected[c] * expected[c];
        errors += error * error;
        worst = std::max(worst, std::abs(error));
      }
    }
  }
  EXPECT_LT(worst, 0.05 * scale) << "at the edges, where slopes are steep";
  EXPECT_LT(std::sqrt(errors / squares), 0.03);
}

TEST(SkinDeformation, EveryRowCarriesTheForces) {
  const Case input = small_case();
  const auto contact = solved(input);
  const StateCombination slide = ContactTimeline(input, contact).at(mid_slide);
  const SkinDeformation skin = deformation(input, contact, mid_slide);
  for (std::size_t row = 0; row < skin.layer.size(); ++row) {
    EXPECT_NEAR(force_through(skin, 2, row), -slide.normal_force(), 2e-3 * slide.normal_force());
    EXPECT_NEAR(force_through(skin, 4, row), slide.tangential_force()[0],
                2e-3 * slide.normal_force());
  }
}

TEST(SkinDeformation, HalfASkinAndAWholeOneAreTheSame) {
  const Case input = small_case();
  const auto half = solved(input), whole = solved(input, true);
  ASSERT_TRUE(half.mesh.half_model() && !whole.mesh.half_model());
  const SkinDeformation a = deformation(input, half, mid_slide),
                        b = deformation(input, whole, mid_slide);
  ASSERT_EQ(a.x.size(), b.x.size());
  ASSERT_EQ(a.y.size(), b.y.size());
  const auto expect_same = [](const auto& these, const auto& others) {
    for (std::size_t c = 0; c < these.size(); ++c) {
      double difference = 0;
      ASSERT_EQ(these[c].size(), others[c].size());
      for (std::size_t i = 0; i < these[c].size(); ++i) {
        difference = std::max(difference, std::abs(these[c][i] - others[c][i]));
      }
      EXPECT_LT(difference, 2e-3 * base::largest_magnitude(these[2])) << c; // beside what goes down
    }
  };
  expect_same(a.displacement, b.displacement);
  expect_same(a.stress, b.stress);
}

TEST(SkinDeformation, NothingMovesUnderADetachedSlider) {
  const Case input = small_case();
  const auto contact = synthetic_contact(input);
  const SkinDeformation skin = deformation(input, contact, 0);
  EXPECT_NEAR(skin.z.back(), input.skin.thickness(), 1e-12);
  EXPECT_EQ(skin.displacement[2].size(), skin.x.size() * skin.y.size() * skin.z.size());
  EXPECT_EQ(skin.stress[2].size(), (skin.x.size() - 1) * (skin.y.size() - 1) * (skin.z.size() - 1));
  EXPECT_EQ(base::largest_magnitude(skin.displacement[2]), 0);
  EXPECT_EQ(base::largest_magnitude(skin.stress[4]), 0);
}

} // namespace
} // namespace ionskin::handover
