// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/wave_bands.hpp"

#include "fields_of.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace ionskin::finite_layers {
namespace {

/// A core that is some hundred times as thick as its electrodes.
FieldCase thick_core() {
  FieldCase skin;
  skin.layers = {elastic_layer(168e9, 0.38, 5e-6), elastic_layer(249e6, 0.49, 0.8e-3),
                 elastic_layer(168e9, 0.38, 5e-6)};
  return skin;
}

ContactGrid small_contact() {
  return {{-50e-6, -20e-6, 50e-6}, {-50e-6, 10e-6, 50e-6}, false};
}

std::vector<WaveBand> bands_of(const FieldCase& skin, const ContactGrid& cells, double last) {
  FieldSkin bare;
  bare.layers = skin.layers;
  bare.length = skin.length;
  bare.width = skin.width;
  return wave_bands(bare, cells, skin.split, last);
}

TEST(WaveBands, SumToTheStrainOfModesThatAreNotDivided) {
  FieldCase divided = thick_core(), undivided = thick_core();
  divided.split = WaveSplit(1e-3, 1e-4);
  undivided.split = WaveSplit(60e-6, 1e-4);
  const ContactGrid cells = small_contact();
  ASSERT_GE(bands_of(divided, cells, 1e6).size(), 4);
  ASSERT_EQ(bands_of(undivided, cells, 1e6).size(), 2);
  const double x = 1.1e-3, y = 0.4e-3;
  // Beneath the contact, at its border and where the shortest waves have ended.
  const TestGrid grid{{x - 0.3e-3, x - 50e-6, x, x + 70e-6, x + 0.9e-3},
                      {y - 0.2e-3, y, y + 50e-6, y + 0.5e-3},
                      {0.1e-3, 0.5e-3, 0.75e-3, 0.79e-3},
                      {x - 50e-6, x + 50e-6, x + 0.5e-3, 3e-3},
                      {y - 50e-6, y + 50e-6, 1.2e-3}};
  const std::vector<double> force{1, 0.3, 0.2, 0.8, -0.2, 0.1, 1.3, 0.4, -0.3, 0.6, 0.1, 0.25};
  const CoreAndElectrodes expected = FieldsOf(undivided, cells, grid).at({x, y}, force);
  const PlacesAcross across{y, points(grid.y), grid.column_y};
  for (const bool rows : {false, true}) {
    const CoreAndElectrodes found =
        FieldsOf(divided, cells, grid, rows ? std::optional(across) : std::nullopt)
            .at({x, y}, force);
    EXPECT_LT(difference(found.core, expected.core), 1e-4) << rows;
    EXPECT_LT(difference(found.electrodes, expected.electrodes), 1e-4) << rows;
  }
}

TEST(WaveBands, OfAThickCoreAreFewModes) {
  FieldCase skin;
  skin.length = 20e-3;
  skin.width = 10e-3;
  skin.split = WaveSplit(6e-3, 1e-3);
  const double last = 4.6e6; // felt 2 um below the face
  const std::vector<WaveBand> bands = bands_of(skin, small_contact(), last);
  double modes = 0;
  for (const WaveBand& band : bands) {
    modes += static_cast<double>(band.waves.modes_x() * band.waves.modes_y());
  }
  EXPECT_LT(modes, 1e6); // one box of 12 mm: 1.8e8
  for (std::size_t i = 1; i < bands.size(); ++i) {
    EXPECT_LT(bands[i].length, bands[i - 1].length);
    EXPECT_GT(bands[i].waves.step_x(), bands[i - 1].waves.step_x());
  }
  EXPECT_GE(static_cast<double>(bands.back().waves.modes_x()) * bands.back().waves.step_x(), last);
}

TEST(WaveBands, OfWideContactsAreTheModesOfTheSkinAndOneBox) {
  const FieldCase skin;
  const ContactGrid wide{{-1e-3, 0, 1e-3}, {-0.3e-3, 0, 0.3e-3}, false};
  EXPECT_EQ(bands_of(skin, wide, 1e6).size(), 2);
}

TEST(WaveBands, KeepTheirBoxesWithinTheSkin) {
  const FieldCase skin;
  const WaveBand near = bands_of(skin, small_contact(), 1e5).at(1);
  const PlaneBox corner = near.box({20e-6, skin.width - 20e-6});
  EXPECT_EQ(corner.x, 0);
  EXPECT_DOUBLE_EQ(corner.y + corner.width, skin.width);
}

} // namespace
} // namespace ionskin::finite_layers
