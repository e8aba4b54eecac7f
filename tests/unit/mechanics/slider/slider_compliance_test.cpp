// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_compliance.hpp"

#include "ionskin/mechanics/skin/skin_model.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace ionskin::mechanics {
namespace {

using Eigen::MatrixXd;

MotionBox start_of(const Case& input) {
  return {input.slider.start, input.slider.start};
}

Case soft_case(double pad_thickness = 0) {
  Case input = small_case();
  input.slider.youngs_modulus = 1e8;
  input.slider.poissons_ratio = 0.4;
  input.slider.pad_thickness = pad_thickness;
  return input;
}

MatrixXd compliance(const Case& input, mesh::MeshedPart part = mesh::MeshedPart::whole) {
  return SkinModel(input, mesh::largest_footprint(input), start_of(input), part).slider_compliance;
}

/// Mean displacement of all cells, weighted with their area, under even traction, over the traction
/// [m/Pa]: normal, and along x.
std::array<double, 2> even_response(const Case& input, mesh::MeshedPart part) {
  const SkinModel model(input, mesh::largest_footprint(input), start_of(input), part);
  std::array<double, 2> sum{};
  double area = 0;
  for (int at = 0; at < static_cast<int>(model.cells.count()); ++at) {
    area += model.cells.area[at];
    for (int from = 0; from < static_cast<int>(model.cells.count()); ++from) {
      for (int component : {0, 1}) {
        sum[component] += model.cells.area[at] * model.cells.area[from] *
                          model.slider_compliance(3 * at + component, 3 * from + component);
      }
    }
  }
  return {sum[0] / area, sum[1] / area};
}

TEST(SliderCompliance, IsEmptyOfARigidSlider) {
  EXPECT_TRUE(compliance(small_case()).size() == 0);
}

TEST(SliderCompliance, IsSymmetricAndInInverseProportionToTheModulus) {
  Case input = soft_case();
  const MatrixXd soft = compliance(input);
  input.slider.youngs_modulus *= 10;
  const MatrixXd stiffer = compliance(input);
  ASSERT_GT(soft.size(), 0);
  for (int i = 0; i < soft.rows(); ++i) {
    EXPECT_GT(soft(i, i), 0);
    for (int j = 0; j <= i; ++j) {
      EXPECT_EQ(soft(i, j), soft(j, i));
      EXPECT_NEAR(soft(i, j), 10 * stiffer(i, j), 1e-12 * soft(i, i));
    }
  }
}

TEST(SliderCompliance, OfIncompressibleMaterialIsTheLimit) {
  const finite_layers::ContactGrid grid{{0, 0.1e-3, 0.3e-3}, {0, 0.2e-3}};
  for (const double pad : {0.0, 0.1e-3}) {
    const auto at = [&](double poissons_ratio) {
      Slider slider = soft_case(pad).slider;
      slider.poissons_ratio = poissons_ratio;
      return slider_compliance(slider, grid);
    };
    const MatrixXd limit = at(0.5), near = at(0.499), further = at(0.498);
    ASSERT_TRUE(limit.allFinite());
    const double error = (limit - (2 * near - further)).cwiseAbs().maxCoeff();
    EXPECT_LT(error, 0.02 * (limit - near).cwiseAbs().maxCoeff()) << pad;
  }
}

TEST(SliderCompliance, OfAHalfModelIsThatOfTheWholeUnderMirroredForces) {
  for (const double pad : {0.0, 0.4e-3}) {
    const Case input = soft_case(pad);
    const auto whole = even_response(input, mesh::MeshedPart::whole);
    const auto half = even_response(input, mesh::MeshedPart::half_if_symmetric);
    for (const int component : {0, 1}) {
      EXPECT_NEAR(half[component], whole[component], 4e-3 * whole[component]);
    }
  }
}

TEST(SliderCompliance, HasTheMeanUnderAnEvenlyPressedRectangle) {
  // The mean of 1/r over a square of side a is 2.9733 a (Love 1929); of this rectangle it is summed
  // here.
  Case input = soft_case();
  input.slider.size = {0.4e-3, 0.4e-3};
  input.slider.parameters["edge_radius"] = 0.05e-3; // even tractions
  const auto footprint = mesh::largest_footprint(input);
  const double a = 2 * footprint.half_size[0], b = 2 * footprint.half_size[1];
  ASSERT_NEAR(a, b, 1e-12);
  const double modulus = 1e8 / (1 - 0.4 * 0.4);
  EXPECT_NEAR(even_response(input, mesh::MeshedPart::whole)[0],
              2.9733 * a / (std::numbers::pi * modulus), 3e-3 * a / modulus);
}

TEST(SliderCompliance, OfAThinPadIsThatOfALayer) {
  const double nu = 0.4, shear_modulus = 1e8 / (2 * (1 + nu));
  for (const double thickness : {1e-6, 4e-6}) {
    Case input = soft_case(thickness);
    input.slider.parameters["edge_radius"] = 0.05e-3; // even tractions
    const auto [normal, along_x] = even_response(input, mesh::MeshedPart::whole);
    EXPECT_NEAR(along_x * shear_modulus / thickness, 1, 0.02);
    EXPECT_NEAR(normal * shear_modulus / thickness, (1 - 2 * nu) / (2 * (1 - nu)), 0.02);
  }
}

TEST(SliderCompliance, OfThinAndThickPadsMeet) {
  // They are summed differently; nothing of that is seen in how the response grows.
  std::vector<std::array<double, 2>> responses;
  for (double thickness = 20e-6; thickness < 450e-6; thickness *= 1.5) {
    Case input = soft_case(thickness);
    input.slider.parameters["edge_radius"] = 0.05e-3; // even tractions
    responses.push_back(even_response(input, mesh::MeshedPart::whole));
  }
  for (std::size_t i = 2; i < responses.size(); ++i) {
    for (const std::size_t component : {0, 1}) {
      const auto at = [&](std::size_t place) { return responses[place][component]; };
      EXPECT_NEAR(at(i) / at(i - 1), at(i - 1) / at(i - 2), 0.07) << component << " " << i;
    }
  }
}

TEST(SliderCompliance, AddsToTheSkinsAtAPlace) {
  const Case input = soft_case();
  const SkinModel model(input, mesh::largest_footprint(input), start_of(input));
  MatrixXd both;
  ContactCompliance(model).at(input.slider.start, both);
  const MatrixXd skin =
      model.layers.across(input.slider.start[1]).compliance(input.slider.start[0]);
  EXPECT_EQ(both, skin + model.slider_compliance);
}

TEST(SliderCompliance, OfTheSkinsOwnMaterialLeavesNormalAndTangentialApart) {
  // Two bodies alike: pressure moves both faces alike sideways, so that nothing slips (Dundurs).
  Case input = small_case();
  const double thickness = 3e-3;
  input.skin.length = input.skin.width = 20e-3;
  input.slider.start = {10e-3, 10e-3};
  input.motion.stroke = 1e-3;
  for (Layer& layer : input.skin.layers) {
    layer.material = {"same", 1e8, 0.2};
    layer.thickness = thickness;
  }
  input.slider.youngs_modulus = 1e8;
  input.slider.poissons_ratio = 0.2;
  const SkinModel model(input, mesh::largest_footprint(input), start_of(input),
                        mesh::MeshedPart::whole);
  MatrixXd both;
  ContactCompliance(model).at(input.slider.start, both);
  double skin = 0, rest = 0;
  for (int i = 0; i < both.rows(); i += 3) {
    for (int j = 0; j < both.rows(); j += 3) {
      skin += std::pow(both(i, j + 1) - model.slider_compliance(i, j + 1), 2);
      rest += std::pow(both(i, j + 1), 2);
    }
  }
  EXPECT_LT(std::sqrt(rest / skin), 0.25);
}

} // namespace
} // namespace ionskin::mechanics
