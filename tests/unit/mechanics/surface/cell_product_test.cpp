// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/cell_product.hpp"

#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/slider/slider_compliance.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::mechanics {
namespace {

namespace fl = finite_layers;

/// At one place, the matrix of the compliance and the product that stands for it.
struct BothForms {
  std::string name;
  Eigen::MatrixXd matrix;
  std::shared_ptr<const fl::CellProduct> product;
  fl::ContactGrid grid;
};

/// Both forms of a small skin under even cells, near an end of it.
BothForms both_forms(const std::string& name, const Case& input, bool half, double centre_y) {
  BothForms forms{name, {}, {}, {}};
  const double height = 0.7e-4;
  for (int i = 0; i <= 8; ++i) {
    forms.grid.x.push_back((i - 4) * 1e-4);
  }
  for (int j = 0; j <= 6; ++j) {
    forms.grid.y.push_back(half ? (j - 6) * height : (j - 3) * height);
  }
  forms.grid.half = half;
  const std::array<double, 2> centre{1e-3, centre_y};
  const fl::LayeredSkin skin(input.skin, forms.grid, fl::skin_resolution(input.skin, {6e-4, 4e-4}));
  forms.matrix = skin.across(centre_y).compliance(centre[0]);
  auto convolution = std::make_shared<fl::CellConvolution>(forms.grid);
  convolution->include(skin.short_waves(), fl::own_images(forms.grid));
  convolution->include(skin.short_waves(), skin.images_in_sides(centre_y));
  std::vector<fl::WavesOfBody> bodies{skin.waves()};
  if (!input.slider.rigid()) {
    const SliderFace face = slider_face(input.slider);
    convolution->include(face.compliance, fl::own_images(forms.grid), mixed_of_slider);
    bodies.push_back(face.waves);
    forms.matrix += slider_compliance(input.slider, forms.grid);
  }
  forms.product = std::make_shared<const fl::CellProduct>(
      std::move(convolution), skin.long_waves(centre),
      std::make_shared<const fl::InverseWaves>(forms.grid, bodies));
  return forms;
}

/// Free and held sides, a half and a whole grid, and a soft slider.
const std::vector<BothForms>& all_forms() {
  static const std::vector<BothForms> forms = [] {
    Case free = small_case(), held = free, soft = free;
    free.skin.sides = soft.skin.sides = SideCondition::free;
    held.skin.sides = SideCondition::symmetry;
    soft.slider.youngs_modulus = 1e8;
    const double middle = free.skin.width / 2;
    return std::vector{both_forms("free, whole", free, false, 0.8 * middle),
                       both_forms("free, half", free, true, middle),
                       both_forms("held, whole", held, false, 0.8 * middle),
                       both_forms("soft, half", soft, true, middle)};
  }();
  return forms;
}

TEST(CellProduct, IsTheMatrixTimesForces) {
  for (const BothForms& forms : all_forms()) {
    CellVector force(static_cast<std::size_t>(forms.matrix.rows()));
    for (std::size_t i = 0; i < force.size(); ++i) {
      force[i] = std::sin(1.7 * static_cast<double>(i * i % 23)) + 0.3;
    }
    const Eigen::Map<const Eigen::VectorXd> forces(force.data(), forms.matrix.rows());
    const Eigen::VectorXd expected = forms.matrix * forces;
    const CellVector moved = forms.product->times(force);
    const Eigen::Map<const Eigen::VectorXd> found(moved.data(), forms.matrix.rows());
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff())
        << forms.name;
  }
}

/// A contact of a round slider that sticks here and slips there, and leaves cells open.
SurfaceState solved(const BothForms& forms, bool by_products, LoadKind kind) {
  const std::size_t cells = static_cast<std::size_t>(forms.grid.count());
  ContactProblem problem{{}, {}, {}, laws::friction("coulomb", 0.3, {})};
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto i = static_cast<Eigen::Index>(cell);
    const fl::Interval x = forms.grid.column(i % forms.grid.columns()),
                       y = forms.grid.row(i / forms.grid.columns());
    problem.area.push_back(x.size() * y.size());
    problem.gap.push_back(20 * (x.middle() * x.middle() + y.middle() * y.middle()));
  }
  if (by_products) {
    problem.product = forms.product;
  } else {
    problem.compliance = forms.matrix;
  }
  const CellVector none(3 * cells, 0.0);
  const SliderLoad load{kind, kind == LoadKind::force ? 0.1 : 1e-6};
  return solve_contact_step(problem, {load, {3e-7, 1e-7}, 0.1, none}, none);
}

TEST(CellProduct, ContactsAreThoseOfTheMatrix) {
  for (const BothForms& forms : all_forms()) {
    for (const LoadKind kind : {LoadKind::force, LoadKind::indentation}) {
      const SurfaceState expected = solved(forms, false, kind), found = solved(forms, true, kind);
      double largest = 0, difference = 0;
      std::size_t open = 0;
      for (std::size_t i = 0; i < expected.force.size(); ++i) {
        largest = std::max(largest, std::abs(expected.force[i]));
        difference = std::max(difference, std::abs(found.force[i] - expected.force[i]));
        open += i % 3 == 0 && expected.force[i] == 0 ? 1 : 0;
      }
      EXPECT_GT(open, 0U) << forms.name; // or nothing is chosen
      EXPECT_LT(open, expected.force.size() / 3) << forms.name;
      EXPECT_LT(difference, 1e-8 * largest) << forms.name;
      EXPECT_NEAR(found.indentation, expected.indentation, 1e-8 * expected.indentation);
    }
  }
}

} // namespace
} // namespace ionskin::mechanics
