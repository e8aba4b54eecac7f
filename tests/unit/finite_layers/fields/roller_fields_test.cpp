// SPDX-License-Identifier: Apache-2.0
#include "fields_of.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/finite_layers/plane/box_modes.hpp"

#include <gtest/gtest.h>

namespace ionskin::finite_layers {
namespace {

ContactGrid few_cells() {
  return {{-0.2e-3, -0.05e-3, 0.1e-3, 0.2e-3}, {-0.1e-3, 0, 0.15e-3}, false};
}

TestGrid even_grid() {
  return {{0.3e-3, 0.71e-3, 0.9e-3, 1.02e-3, 1.3e-3, 2.4e-3},
          {0.2e-3, 0.41e-3, 0.55e-3, 0.7e-3, 1.1e-3},
          {10e-6, 90e-6, 150e-6, 175e-6},
          {0, 0.6e-3, 0.9e-3, 1.1e-3, 3e-3},
          {0, 0.4e-3, 0.6e-3, 1.2e-3}};
}

/// No two alike [N].
std::vector<double> forces(const ContactGrid& cells) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < 3 * cells.count(); ++i) {
    result.push_back(1 + 0.7 * std::sin(2.0 * static_cast<double>(i)));
  }
  return result;
}

TEST(RollerFields, UnderAnEvenLoadAreThoseOfAColumn) {
  const FieldCase skin;
  const ContactGrid whole{{-1.5e-3, 0, 1.5e-3}, {-0.6e-3, 0, 0.6e-3}, false};
  const double pressure = 1e5;
  std::vector<double> even(12, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    even[3 * i] = pressure * skin.length * skin.width / 4;
  }
  const CoreAndElectrodes found = FieldsOf(skin, whole, even_grid()).at({1.5e-3, 0.6e-3}, even);
  const double core = -pressure / skin.layers[1].oedometric_modulus(),
               electrode = -pressure / skin.layers[0].oedometric_modulus();
  const auto expect_stretch = [](const StrainField& field, double expected) {
    StrainField stretch = field;
    for (std::size_t c = 0; c < 6; ++c) {
      std::ranges::fill(stretch.component[c], c == 2 ? expected : 0.0);
    }
    EXPECT_LT(difference(field, stretch), 1e-6);
  };
  expect_stretch(found.core, core);
  expect_stretch(found.electrodes, electrode);
}

// The stretch through the thickness adds up to the displacement of the surface. Of the core only
// points are known: it is a hundredth of the polymer here.
TEST(RollerFields, AddUpToTheComplianceOfACell) {
  FieldCase skin;
  const ElasticLayer metal = skin.layers[0], polymer = skin.layers[1];
  const auto layer = [](ElasticLayer of, double thickness) {
    of.thickness = thickness;
    return of;
  };
  skin.layers = {metal, layer(polymer, 89e-6), layer(polymer, 2e-6), layer(polymer, 89e-6), metal};
  skin.elements = {{1}, {1}, {1}, {1}, {1}};
  skin.core = 2;
  skin.tolerance = 1e-7;
  const ContactGrid one = few_cells();
  const std::vector<double> force = forces(one);
  const std::array<double, 2> centre{0.9e-3, 0.5e-3};
  // The place is a cell: middle column of the second row.
  const double x = centre[0], y = centre[1];
  TestGrid at{{}, {}, {1e-6}, {x - 0.05e-3, x + 0.1e-3}, {y, y + 0.15e-3}};
  constexpr int points = 8; // of a midpoint rule over the cell, for the core
  for (int i = 0; i < points; ++i) {
    at.x.push_back(x - 0.05e-3 + (i + 0.5) / points * 0.15e-3);
    at.y.push_back(y + (i + 0.5) / points * 0.15e-3);
  }
  const CoreAndElectrodes found = FieldsOf(skin, one, at).at(centre, force);
  double moved = 0;
  for (std::size_t level = 0; level < 4; ++level) {
    moved +=
        found.electrodes.component[2][level] * skin.layers[level < 2 ? level : level + 1].thickness;
  }
  for (const double value : found.core.component[2]) {
    moved += value / (points * points) * skin.layers[2].thickness;
  }
  const SurfaceCompliance surface(skin.layers);
  const BoxModes modes(surface, skin.length, skin.width, skin.split);
  Eigen::MatrixXd compliance =
      plane_compliance(PlaneCompliance(surface, skin.split), one, own_images(one));
  const auto rows = modes.rows(one, centre[1]);
  const Eigen::ArrayXd all = Eigen::ArrayXd::Ones(modes.along_x().wave_numbers.size());
  for (const ModePart part : {ModePart::alike, ModePart::mirrored}) {
    add_modes(rows, modes.along_x(), part, all, one, centre[0], compliance);
  }
  const Eigen::VectorXd surface_moved =
      compliance * Eigen::Map<const Eigen::VectorXd>(force.data(), 18);
  EXPECT_NEAR(-moved, surface_moved(3 * 4), 1e-3 * surface_moved(3 * 4));
}

TEST(RollerFields, DoNotDependOnWhereTheWavesAreDivided) {
  FieldCase one, other;
  one.split = WaveSplit(0.25e-3, 1e-4);
  other.split = WaveSplit(0.5e-3, 1e-4);
  // The slider is near a side and an end, which mirror short waves, too.
  const std::array<double, 2> centre{0.5e-3, 0.4e-3};
  const CoreAndElectrodes
      a = FieldsOf(one, few_cells(), even_grid()).at(centre, forces(few_cells())),
      b = FieldsOf(other, few_cells(), even_grid()).at(centre, forces(few_cells()));
  EXPECT_LT(difference(a.core, b.core), 1e-4);
  EXPECT_LT(difference(a.electrodes, b.electrodes), 1e-4);
}

TEST(RollerFields, ConvergeWithTheTolerance) {
  FieldCase usual, tight;
  tight.tolerance = 1e-8; // twice the cut-offs
  const std::array<double, 2> centre{0.9e-3, 0.5e-3};
  const CoreAndElectrodes
      a = FieldsOf(usual, few_cells(), even_grid()).at(centre, forces(few_cells())),
      b = FieldsOf(tight, few_cells(), even_grid()).at(centre, forces(few_cells()));
  EXPECT_LT(difference(a.core, b.core), 3e-4);
  EXPECT_LT(difference(a.electrodes, b.electrodes), 1e-3);
}

// div sigma = 0 by central differences in the core.
TEST(RollerFields, AreInEquilibrium) {
  const FieldCase skin;
  const double step = 2e-6, x = 1.03e-3, y = 0.61e-3, z = 130e-6;
  const TestGrid around{{x - step, x, x + step},
                        {y - step, y, y + step},
                        {z - step, z, z + step},
                        {0, 3e-3},
                        {0, 1.2e-3}};
  const StrainField strain =
      FieldsOf(skin, few_cells(), around).at({0.9e-3, 0.5e-3}, forces(few_cells())).core;
  const double lambda = skin.layers[1].lame_lambda, mu = skin.layers[1].shear_modulus;
  const auto stress = [&](std::size_t c, const std::array<std::size_t, 3>& at) {
    const std::size_t i = at[0] + 3 * (at[1] + 3 * at[2]);
    const auto e = [&](std::size_t component) { return strain.component[component][i]; };
    return 2 * mu * e(c) + (c < 3 ? lambda * (e(0) + e(1) + e(2)) : 0);
  };
  const auto slope = [&](std::size_t c, std::size_t direction) {
    std::array<std::size_t, 3> next{1, 1, 1}, before{1, 1, 1};
    next[direction] = 2;
    before[direction] = 0;
    return (stress(c, next) - stress(c, before)) / (2 * step);
  };
  constexpr std::array<std::array<std::size_t, 3>, 3> component{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};
  for (std::size_t i = 0; i < 3; ++i) {
    double total = 0, size = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      total += slope(component[i][j], j);
      size = std::max(size, std::abs(slope(component[i][j], j)));
    }
    EXPECT_LT(std::abs(total), 3e-3 * size) << i;
  }
}

TEST(RollerFields, HandTheNormalForceOnThroughEveryLevel) {
  const ContactGrid one = few_cells();
  const std::vector<double> force = forces(one);
  const CoreAndElectrodes found =
      FieldsOf(FieldCase{}, one, even_grid()).at({0.9e-3, 0.5e-3}, force);
  ASSERT_EQ(found.force_through_level.size(), 4);
  for (const auto& through : found.force_through_level) {
    EXPECT_NEAR(through[0], sum(force, 0), 1e-4 * sum(force, 0));
    // Rollers at ends and sides bear no shear force, but take normal forces along x and y.
    EXPECT_LT(through[1], sum(force, 1));
  }
}

TEST(RollerFields, OfTheHalfAreThoseOfTheWholeUnderMirroredForces) {
  const FieldCase skin;
  const ContactGrid half{{-0.2e-3, 0, 0.3e-3}, {-0.3e-3, -0.2e-3, 0}, true},
      whole{half.x, {-0.3e-3, -0.2e-3, 0, 0.2e-3, 0.3e-3}, false};
  const std::vector<double> of_half = forces(half);
  std::vector<double> of_whole(24);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 6; ++i) { // of a row of two cells
      const std::size_t from = 6 * std::min(j, 3 - j) + i;
      of_whole[6 * j + i] = (j > 1 && i % 3 == 2 ? -1 : 1) * of_half[from];
    }
  }
  TestGrid lower = even_grid();
  lower.y = {0.1e-3, 0.35e-3, 0.6e-3};
  lower.column_y = {0, 0.3e-3, 0.6e-3};
  const CoreAndElectrodes a = FieldsOf(skin, half, lower).at({1.2e-3, 0.6e-3}, of_half),
                          b = FieldsOf(skin, whole, lower).at({1.2e-3, 0.6e-3}, of_whole);
  EXPECT_LT(difference(a.core, b.core), 1e-9);
  EXPECT_LT(difference(a.electrodes, b.electrodes), 1e-9);
  EXPECT_NEAR(a.force_through_level[1][0], b.force_through_level[1][0],
              1e-9 * b.force_through_level[1][0]);
}

TEST(RollerFields, AreTheSameBitsWhateverWasAskedForBefore) {
  const FieldsOf fields(FieldCase{}, few_cells(), even_grid());
  const std::vector<double> force = forces(few_cells());
  const CoreAndElectrodes first = fields.at({0.9e-3, 0.5e-3}, force);
  fields.at({2.1e-3, 0.7e-3}, force);
  const CoreAndElectrodes again = fields.at({0.9e-3, 0.5e-3}, force);
  EXPECT_EQ(first.core.component, again.core.component);
  EXPECT_EQ(first.electrodes.component, again.electrodes.component);
}

TEST(RollerFields, AskForLevelsInTheCoreAndThreeForcesACell) {
  for (const double z : {-1e-6, 181e-6}) {
    TestGrid outside = even_grid();
    outside.z = {z};
    EXPECT_THROW(FieldsOf(FieldCase{}, few_cells(), outside), InternalError);
  }
  EXPECT_THROW(FieldsOf(FieldCase{}, few_cells(), even_grid()).at({0.9e-3, 0.5e-3}, {1, 2, 3}),
               InternalError);
}

void expect_alike(const CoreAndElectrodes& one, const CoreAndElectrodes& other) {
  EXPECT_LT(difference(one.core, other.core), 1e-12);
  EXPECT_LT(difference(one.electrodes, other.electrodes), 1e-12);
  for (std::size_t level = 0; level < other.force_through_level.size(); ++level) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(one.force_through_level[level][c], other.force_through_level[level][c],
                  1e-9 * std::abs(other.force_through_level[level][2]));
    }
  }
}

TEST(RollerFields, OfPlacesThatStayAcrossAreThoseOfAny) {
  const FieldCase skin;
  const TestGrid grid = even_grid();
  const ContactGrid cells = few_cells(), half{cells.x, {-0.15e-3, -0.05e-3, 0.0}, true};
  for (const ContactGrid& of : {cells, half}) {
    const double y = of.half ? skin.width / 2 : 0.55e-3;
    const FieldsOf any(skin, of, grid),
        staying(skin, of, grid, PlacesAcross{y, points(grid.y), grid.column_y});
    for (const double x : {0.9e-3, 1.6e-3, 2.7e-3}) { // the last near an end
      expect_alike(staying.at({x, y}, forces(of)), any.at({x, y}, forces(of)));
    }
    EXPECT_THROW(staying.at({0.9e-3, y + 1e-6}, forces(of)), InternalError);
  }
}

TEST(RollerFields, HaveTheComponentsThatWereChosen) {
  const FieldCase skin;
  const ContactGrid cells = few_cells();
  const std::array<double, 2> centre{0.9e-3, 0.55e-3};
  const ComponentChoice chosen{false, false, false, true, true, true};
  const TestGrid grid = even_grid();
  const CoreAndElectrodes all = FieldsOf(skin, cells, grid).at(centre, forces(cells));
  const CoreAndElectrodes some =
      FieldsOf(skin, cells, grid, std::nullopt, chosen).at(centre, forces(cells));
  CoreAndElectrodes expected = all;
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(some.core.component[c].empty(), !chosen[c]);
    if (!chosen[c]) {
      expected.core.component[c].clear();
    }
  }
  expect_alike(some, expected);
}

} // namespace
} // namespace ionskin::finite_layers
