// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/handover.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

namespace ionskin::handover {
namespace {

void expect_conserved(const Case& input) {
  const auto contact = synthetic_contact(input);
  const auto history = build_strain_history(input, contact);
  const ContactTimeline timeline(input, contact);
  const auto& times = timeline.sample_times();
  for (std::size_t i = 0; i < times.size(); i += 5) {
    const double expected = mechanics_shear_integral(input, contact.mesh, timeline.at(times[i]));
    EXPECT_NEAR(history::shear_integral(history, times[i]), expected, 1e-12 * expected)
        << "at " << times[i];
  }
}

TEST(Handover, ConservesTheIntegralOfTheHalfModel) {
  expect_conserved(small_case());
}

TEST(Handover, ConservesTheIntegralOfAnOffCentreTrack) {
  Case input = small_case();
  input.slider.start[1] = 0.9e-3;
  expect_conserved(input);
}

TEST(Handover, ConservesTheIntegralOfAnObliqueTrack) {
  Case input = small_case();
  input.slider.size = {3e-3, 1e-3};
  input.motion.stroke = 1e-3;
  input.motion.direction = {0.96, 0.28};
  expect_conserved(input);
}

/// A case with every length multiplied.
Case scaled_case(double factor) {
  Case input = small_case();
  for (double* length : {&input.skin.length, &input.skin.width, &input.slider.size[0],
                         &input.slider.size[1], &input.slider.start[0], &input.slider.start[1],
                         &input.motion.gap, &input.motion.preload, &input.motion.stroke}) {
    *length *= factor;
  }
  for (Layer& layer : input.skin.layers) {
    layer.thickness *= factor;
  }
  return input;
}

TEST(Handover, CellsBesideTheFootprintScaleWithTheSkin) {
  const auto edges = [](const Case& input) {
    return build_strain_history(input, synthetic_contact(input)).grid.x_edges;
  };
  const auto small = edges(small_case()), large = edges(scaled_case(16));
  ASSERT_EQ(large.size(), small.size());
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_NEAR(large[i], 16 * small[i], 1e-12);
  }
}

TEST(Handover, ThinSkinsHaveNoMoreCellsBesideTheFootprintThanTheirLengthNeeds) {
  Case input = small_case();
  input.skin.layers = {{"bottom", LayerRole::electrode, input.skin.layers[0].material, 1e-6},
                       {"core", LayerRole::core, input.skin.layers[1].material, 18e-6},
                       {"top", LayerRole::electrode, input.skin.layers[2].material, 1e-6}};
  input.motion.preload = 1e-7;
  const history::CoreHistory history = build_strain_history(input, synthetic_contact(input));
  EXPECT_LT(history.grid.x_edges.size(), 300u);
}

TEST(Handover, RepeatsTheCycleWithoutCopies) {
  const Case input = small_case();
  const auto contact = synthetic_contact(input);
  const auto history = build_strain_history(input, contact);
  const std::size_t one_cycle = ContactTimeline(input, contact).sample_times().size();
  ASSERT_EQ(history.time.size(), 2 * one_cycle - 1);
  EXPECT_EQ(history.shear()[5].get(), history.shear()[one_cycle + 4].get());
  EXPECT_DOUBLE_EQ(history.time.back(), 8.0);
  EXPECT_EQ(history.event_time.size(), 8u);
  EXPECT_NEAR(history.event_time[4], 4 + history.event_time[0], 1e-12);
}

TEST(Handover, TouchdownIsProportionalToTheIndentation) {
  const Case input = small_case();
  const auto contact = synthetic_contact(input);
  const auto history = build_strain_history(input, contact);
  const double contact_time = 0.5 * 1000.0 / 1001.0;
  const double half = history::shear_integral(history, 0.5 * (contact_time + 0.5));
  EXPECT_NEAR(half, 0.5 * history::shear_integral(history, 0.5), 1e-12 * half);
  EXPECT_EQ(history::shear_integral(history, contact_time), 0.0);
}

TEST(Handover, RefusesShearThatIsNotANumberAndNamesTheContact) {
  const Case input = small_case();
  auto contact = synthetic_contact(input);
  mechanics::ContactState broken = *contact.stepped[8].state;
  broken.strain.component[4][17] = std::nan("");
  contact.stepped[8].state = std::make_shared<const mechanics::ContactState>(std::move(broken));
  try {
    build_strain_history(input, contact);
    FAIL() << "a NaN passed the handover";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("friction law \"coulomb\""), std::string::npos)
        << error.what();
  }
}

} // namespace
} // namespace ionskin::handover
