// SPDX-License-Identifier: Apache-2.0
#include "fields_of.hpp"

#include <gtest/gtest.h>

namespace ionskin::finite_layers {
namespace {

/// A square skin, so that ends are to x what sides are to y.
FieldCase all_free() {
  FieldCase skin;
  skin.length = skin.width = 1.2e-3;
  skin.degree = 3;
  skin.elements = {{1}, {1, 1}, {1}};
  skin.sides_free = skin.ends_free = true;
  skin.sides = skin.ends = {16, 60};
  return skin;
}

ContactGrid mirrored_cells() {
  return {{-0.2e-3, -0.05e-3, 0.1e-3}, {-0.1e-3, 0, 0.15e-3}, false};
}

TestGrid grid() {
  return {{0.2e-3, 0.55e-3, 0.7e-3, 1.0e-3},
          {0.2e-3, 0.41e-3, 0.55e-3, 0.7e-3, 1.0e-3},
          {20e-6, 90e-6, 165e-6},
          {0, 0.3e-3, 0.6e-3, 1.2e-3},
          {0, 0.4e-3, 0.6e-3, 1.2e-3}};
}

/// No two alike [N].
std::vector<double> forces() {
  std::vector<double> result;
  for (int i = 0; i < 12; ++i) {
    result.push_back(1 + 0.7 * std::sin(2.0 * i));
  }
  return result;
}

/// Stress in the core at a point, xx, yy, zz, yz, xz, xy [Pa].
std::array<double, 6> stress(const ElasticLayer& layer, const StrainField& strain, std::size_t at) {
  double volume = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    volume += strain.component[c][at];
  }
  std::array<double, 6> result{};
  for (std::size_t c = 0; c < 6; ++c) {
    result[c] = 2 * layer.shear_modulus * strain.component[c][at] +
                (c < 3 ? layer.lame_lambda * volume : 0);
  }
  return result;
}

/// Elements that resolve what a nearly incompressible core does at its faces.
FieldCase well_resolved() {
  FieldCase skin = all_free();
  skin.degree = 5;
  skin.elements = {{1}, {1, 2, 3, 3, 2, 1}, {1}};
  return skin;
}

// Inside the core; near the films free edges strain it without bound.
TEST(FreeFields, BearNoStressOnFacesAndHandAllForcesOnThroughEveryLevel) {
  const ContactGrid half{{-0.2e-3, -0.05e-3, 0.1e-3}, {-0.15e-3, 0}, true};
  const std::vector<double> force{1, 0.4, 0.2, 0.7, -0.1, 0.5};
  const TestGrid faces{{0, 0.6e-3}, {0, 0.5e-3}, {60e-6, 80e-6, 110e-6}, {0, 1.2e-3}, {0, 0.6e-3}};
  const CoreAndElectrodes found =
      FieldsOf(well_resolved(), half, faces).at({0.5e-3, 0.6e-3}, force);
  const auto expect_free = [&](std::size_t point, const std::array<std::size_t, 3>& components) {
    for (std::size_t level = 0; level < 3; ++level) {
      const std::array<double, 6> at = stress(paper_skin()[1], found.core, point + 4 * level),
                                  beneath = stress(paper_skin()[1], found.core, 3 + 4 * level);
      for (const std::size_t c : components) {
        EXPECT_LT(std::abs(at[c]), 5e-3 * std::abs(beneath[2]))
            << "level " << level << ", component " << c;
      }
    }
  };
  expect_free(1, {1, 3, 5}); // of a side
  expect_free(2, {0, 4, 5}); // of an end
  for (const auto& through : found.force_through_level) {
    EXPECT_NEAR(through[0], 2 * sum(force, 0), 1e-4 * 2 * sum(force, 0));
    EXPECT_NEAR(through[1], 2 * sum(force, 1), 1e-4 * 2 * sum(force, 0));
    EXPECT_NEAR(through[2], 0, 1e-9);
  }
}

TEST(FreeFields, AreAlikeUnderAnExchangeOfXAndY) {
  const ContactGrid one = mirrored_cells(), other{one.y, one.x, false};
  const TestGrid at_one = grid(),
                 at_other{at_one.y, at_one.x, at_one.z, at_one.column_y, at_one.column_x};
  const std::vector<double> force = forces();
  std::vector<double> exchanged(12);
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const std::size_t image = cell / 2 + 2 * (cell % 2);
    exchanged[3 * image] = force[3 * cell];
    exchanged[3 * image + 1] = force[3 * cell + 2];
    exchanged[3 * image + 2] = force[3 * cell + 1];
  }
  const CoreAndElectrodes a = FieldsOf(all_free(), one, at_one).at({0.5e-3, 0.45e-3}, force),
                          b = FieldsOf(all_free(), other, at_other)
                                  .at({0.45e-3, 0.5e-3}, exchanged);
  const auto back = [](const StrainField& field) {
    constexpr std::array<std::size_t, 6> component{1, 0, 2, 4, 3, 5};
    StrainField result{{field.points[1], field.points[0], field.points[2]}, {}};
    const std::size_t nx = field.points[0], ny = field.points[1], count = nx * ny * field.points[2];
    for (std::size_t c = 0; c < 6; ++c) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t y = i % ny, x = i / ny % nx, z = i / (nx * ny);
        result.component[c].push_back(field.component[component[c]][x + nx * (y + ny * z)]);
      }
    }
    return result;
  };
  EXPECT_LT(difference(back(b.core), a.core), 3e-3);
  EXPECT_LT(difference(back(b.electrodes), a.electrodes), 3e-3);
}

TEST(FreeFields, ConvergeInModes) {
  FieldCase more = all_free();
  more.sides = more.ends = {24, 90};
  const auto at = [](const FieldCase& skin) {
    return FieldsOf(skin, mirrored_cells(), grid()).at({0.55e-3, 0.5e-3}, forces());
  };
  EXPECT_LT(difference(at(all_free()).core, at(more).core), 3e-3);
}

// Far from the ends fewer waves serve than near them.
TEST(FreeFields, HaveNoJumpOnTheWayFromAnEnd) {
  FieldCase skin = all_free();
  skin.length = 4e-3;
  skin.sides = {30, 60};
  TestGrid from_end{{}, {0.3e-3, 0.7e-3}, {20e-6, 90e-6, 165e-6}, {}, {0, 0.6e-3, 1.2e-3}};
  for (int i = 0; i <= 200; ++i) {
    from_end.x.push_back(1e-3 + i * 2e-6);
  }
  from_end.column_x = from_end.x;
  const ContactGrid near_end{{-0.2e-3, 0.1e-3}, {-0.1e-3, 0, 0.15e-3}, false};
  const CoreAndElectrodes found =
      FieldsOf(skin, near_end, from_end).at({0.3e-3, 0.5e-3}, {1, 0.5, 0.2, 0.8, -0.3, 0.6});
  const auto largest_bend = [](const StrainField& field) {
    double result = 0;
    for (const std::vector<double>& values : field.component) {
      for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        if (i % field.points[0] != 0 && (i + 1) % field.points[0] != 0) {
          result = std::max(result, std::abs(values[i - 1] - 2 * values[i] + values[i + 1]));
        }
      }
    }
    return result / largest(field);
  };
  EXPECT_LT(largest_bend(found.core), 5e-5);
  EXPECT_LT(largest_bend(found.electrodes), 5e-5);
}

TEST(FreeFields, OfTheHalfAreThoseOfTheWholeUnderMirroredForces) {
  const FieldCase skin = all_free();
  const ContactGrid half{{-0.2e-3, 0.3e-3}, {-0.3e-3, 0}, true},
      whole{half.x, {-0.3e-3, 0, 0.3e-3}, false};
  TestGrid lower = grid();
  lower.y = {0.05e-3, 0.35e-3, 0.6e-3};
  lower.column_y = {0, 0.3e-3, 0.6e-3};
  const CoreAndElectrodes a = FieldsOf(skin, half, lower).at({0.6e-3, 0.6e-3}, {1, 0.3, 0.2}),
                          b = FieldsOf(skin, whole, lower)
                                  .at({0.6e-3, 0.6e-3}, {1, 0.3, 0.2, 1, 0.3, -0.2});
  EXPECT_LT(difference(a.core, b.core), 1e-9);
  EXPECT_LT(difference(a.electrodes, b.electrodes), 1e-9);
}

} // namespace
} // namespace ionskin::finite_layers
