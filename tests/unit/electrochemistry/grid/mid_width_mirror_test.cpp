// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"

#include "ionskin/electrochemistry/ion_transport.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace ionskin::electrochemistry {
namespace {

/// Shear of one cell in x and four in y from t = 0.1 s on.
history::CoreHistory strips(const std::vector<double>& shear) {
  auto history = verification::linear_step_history(0.0, 0.0, {0.0, 0.1, 0.2});
  history.grid.y_edges = {0.0, 0.5e-3, 1e-3, 1.5e-3, 2e-3};
  history::StrainField field(4, 0.0);
  field.insert(field.end(), shear.begin(), shear.end());
  const auto none = std::make_shared<const history::StrainField>(8, 0.0);
  const auto some = std::make_shared<const history::StrainField>(field);
  history.shear() = {none, some, some};
  history.event_time = {0.0, 0.1};
  return history;
}

TEST(MidWidthMirror, KnowsMirroredShear) {
  EXPECT_TRUE(is_mirrored(strips({0.1, 0.2, 0.2, 0.1})));
  EXPECT_FALSE(is_mirrored(strips({0.1, 0.2, 0.2, 0.11})));
  EXPECT_TRUE(is_mirrored(verification::sliding_contact_history(1)));
  auto off_centre = verification::sliding_contact_history(1);
  off_centre.slider_y.assign(off_centre.time.size(), 0.8e-3);
  EXPECT_FALSE(is_mirrored(off_centre));
}

TEST(MidWidthMirror, ContinuesFieldsToTheWholeWidth) {
  const MidWidthMirror mirror({{0.0, 1.0, 2.0}, {0.0, 0.5e-3, 1e-3, 1.5e-3, 2e-3}, {0.0, 1.0}},
                              strips({0.1, 0.2, 0.2, 0.1}));
  EXPECT_EQ(mirror.solved_grid().y_edges.size(), 3U);
  EXPECT_EQ(mirror.whole(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}),
            (std::vector<double>{1, 2, 3, 4, 3, 4, 1, 2, 5, 6, 7, 8, 7, 8, 5, 6}));
}

TEST(MidWidthMirror, HalfTheColumnsGiveTheSameSolution) {
  Case input = verification::model_case();
  input.numerics.preset = Preset::coarse;
  input.numerics.time_tolerance = 1e-5;
  base::Timers timers;
  IonOptions options;
  options.snapshot_times = {0.15};
  const auto half = solve_ion_transport(input, strips({0.1, 0.2, 0.2, 0.1}), options, timers);
  // A difference too large for a mirror and too small to matter.
  const auto whole =
      solve_ion_transport(input, strips({0.1, 0.2, 0.2, 0.1 + 1e-10}), options, timers);
  EXPECT_NEAR(half.charge_top.back(), whole.charge_top.back(), 1e-5 * whole.charge_top.back());
  EXPECT_NEAR(half.ion_amount.back(), whole.ion_amount.back(), 1e-12 * whole.ion_amount.back());
  EXPECT_NEAR(half.shear_integral.back(), whole.shear_integral.back(),
              1e-8 * whole.shear_integral.back());
  ASSERT_EQ(half.column_charge_top.size(), whole.column_charge_top.size());
  ASSERT_EQ(half.snapshots.at(0).potential.size(), whole.snapshots.at(0).potential.size());
  for (std::size_t i = 0; i < half.column_charge_top.size(); ++i) {
    EXPECT_NEAR(half.column_charge_top[i], whole.column_charge_top[i],
                1e-4 * whole.column_charge_top[i]);
  }
}

} // namespace
} // namespace ionskin::electrochemistry
