// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "paper_skin.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

constexpr double skin_x = 3e-3, skin_y = 1.2e-3;
const WaveSplit long_waves(0.4e-3, 1e-3);

ThicknessColumn column(int degree) {
  return {paper_skin(), {{1}, {1, 2, 2, 1}, {1}}, degree};
}

struct Faces {
  int degree = 3;
  Eigen::Index along_side = 60, along_end = 24;
  bool sides_free = true, ends_free = true;
};

Eigen::MatrixXd compliance(const ContactGrid& grid, double x, double y, const Faces& faces,
                           double length = skin_x, double width = skin_y) {
  static const SurfaceCompliance surface(paper_skin());
  static const PlaneCompliance short_waves(surface, long_waves);
  const BoxModes modes(surface, length, width, long_waves);
  const ThicknessColumn through = column(faces.degree);
  auto rows = modes.rows(grid, y);
  const FreeSides sides(through, length, width, long_waves, {faces.along_side, 60});
  Eigen::MatrixXd result = plane_compliance(short_waves, grid, own_images(grid));
  if (faces.sides_free) {
    sides.add(grid, y, rows);
  }
  const Eigen::ArrayXd all = Eigen::ArrayXd::Ones(modes.along_x().wave_numbers.size());
  for (const ModePart part : {ModePart::alike, ModePart::mirrored}) {
    add_modes(rows, modes.along_x(), part, all, grid, x, result);
  }
  if (faces.ends_free) {
    const FreeEnds ends(through, length, width, long_waves, {faces.along_end, 120},
                        faces.sides_free ? &sides : nullptr);
    ends.rows(grid, y).add(grid, x, all, 1e9, result);
  }
  return result;
}

ContactGrid cells() {
  return {{-0.2e-3, -0.05e-3, 0.1e-3}, {-0.1e-3, 0, 0.15e-3}};
}

TEST(FreeFaces, SoftenTheSkinAndNeverStiffenIt) {
  const Eigen::MatrixXd rollers = compliance(cells(), 0.5e-3, 0.5e-3,
                                             {.sides_free = false, .ends_free = false}),
                        sides = compliance(cells(), 0.5e-3, 0.5e-3, {.ends_free = false}),
                        all = compliance(cells(), 0.5e-3, 0.5e-3, {});
  const double largest = all.cwiseAbs().maxCoeff();
  for (const Eigen::MatrixXd& softer :
       {Eigen::MatrixXd(sides - rollers), Eigen::MatrixXd(all - sides)}) {
    const Eigen::VectorXd values = softer.selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_GT(values.minCoeff(), -1e-9 * largest);
    EXPECT_GT(values.maxCoeff(), 1e-3 * largest);
  }
}

TEST(FreeFaces, AreAlikeUnderAnExchangeOfXAndY) {
  // The sides of one skin are the ends of the other.
  const ContactGrid one = cells(), other{one.y, one.x};
  const Eigen::MatrixXd a = compliance(one, 0.6e-3, 0.5e-3, {.along_side = 60, .along_end = 36}),
                        b = compliance(other, 0.5e-3, 0.6e-3, {.along_side = 36, .along_end = 60},
                                       skin_y, skin_x);
  const Eigen::Index columns = one.columns(), rows = one.rows();
  const auto exchanged = [&](Eigen::Index cell) {
    return cell / columns + rows * (cell % columns);
  };
  constexpr std::array<Eigen::Index, 3> component{0, 2, 1};
  double worst = 0;
  for (Eigen::Index at = 0; at < one.count(); ++at) {
    for (Eigen::Index from = 0; from < one.count(); ++from) {
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t d = 0; d < 3; ++d) {
          worst = std::max(worst, std::abs(a(3 * at + static_cast<Eigen::Index>(c),
                                             3 * from + static_cast<Eigen::Index>(d)) -
                                           b(3 * exchanged(at) + component[c],
                                             3 * exchanged(from) + component[d])));
        }
      }
    }
  }
  EXPECT_LT(worst, 2e-4 * a.cwiseAbs().maxCoeff());
}

TEST(FreeFaces, ConvergeInModesAndDegree) {
  const Eigen::MatrixXd coarse = compliance(cells(), 0.6e-3, 0.5e-3, {3, 40, 16}),
                        more_modes = compliance(cells(), 0.6e-3, 0.5e-3, {3, 80, 32}),
                        higher_degree = compliance(cells(), 0.6e-3, 0.5e-3, {5, 40, 16});
  const double largest = coarse.cwiseAbs().maxCoeff();
  EXPECT_LT((more_modes - coarse).cwiseAbs().maxCoeff(), 3e-4 * largest);
  EXPECT_LT((higher_degree - coarse).cwiseAbs().maxCoeff(), 2e-3 * largest);
}

TEST(ModeSum, StandsForASumOverAllModesOfAParity) {
  // Sums of 1/(n^2 + a^2) over even and odd n of both signs.
  constexpr double a = 7.3;
  const double half = std::numbers::pi * a / 2;
  const double even = half / (a * a) / std::tanh(half), odd = half / (a * a) * std::tanh(half);
  for (const Parity parity : {Parity::even, Parity::odd}) {
    double sum = 0;
    for (const ModeTerm& term : mode_sum(parity, 60)) {
      sum += term.weight / (term.number * term.number + a * a);
    }
    EXPECT_NEAR(sum, parity == Parity::even ? even : odd, 1e-5 * even);
  }
}

} // namespace
} // namespace ionskin::finite_layers
