// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::verification {
namespace {

using mechanics::ElasticLaw;
using mechanics::ElasticSpace;
using mechanics::Face;
using mechanics::FixedFace;

/// The skin under a uniform traction on its whole top face, other faces held as given.
class LayeredPatch {
public:
  explicit LayeredPatch(const std::vector<FixedFace>& fixed)
      : mesh_(baseline_case()), lines_(mesh_.lines(baseline_case().slider.start)),
        space_(lines_, fixed) {
    const Case input = baseline_case();
    for (const std::size_t layer : mesh_.layer_of_row()) {
      laws_.push_back(mechanics::isotropic_elasticity(input.skin.layers[layer].material));
    }
  }

  void load(int component, double traction) {
    linear_algebra::DenseMatrix load(space_.unknowns(), 1);
    const auto [nx, ny, nz] = space_.elements();
    constexpr std::array<double, 3> weight{1.0 / 6, 4.0 / 6, 1.0 / 6};
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        const double force =
            traction * (lines_.x[i + 1] - lines_.x[i]) * (lines_.y[j + 1] - lines_.y[j]);
        for (std::size_t a = 0; a < 9; ++a) {
          const int unknown =
              space_.unknown(space_.node_at(2 * i + a % 3, 2 * j + a / 3, 2 * nz))[component];
          if (unknown >= 0) {
            load(unknown, 0) += force * weight[a % 3] * weight[a / 3];
          }
        }
      }
    }
    const auto system = mechanics::assemble(space_, lines_, laws_);
    const linear_algebra::SymbolicCholesky symbolic(space_.pattern(), space_.elimination_order({}),
                                                    0);
    displacement_ = linear_algebra::Cholesky(symbolic, system.stiffness).solve(load);
  }

  /// Largest deviation, over the largest exact displacement, from a displacement along one
  /// component that is linear in z within each layer with strain traction / modulus(law).
  double error(int component, double traction, double (*modulus)(const ElasticLaw&)) const {
    std::vector<double> exact{0.0}; // at the z lines
    for (std::size_t row = 0; row < laws_.size(); ++row) {
      exact.push_back(exact.back() +
                      (lines_.z[row + 1] - lines_.z[row]) * traction / modulus(laws_[row]));
    }
    const auto [nx, ny, nz] = space_.elements();
    double worst = 0;
    for (std::size_t k = 0; k <= 2 * nz; ++k) {
      const double expected = k % 2 == 0 ? exact[k / 2] : (exact[k / 2] + exact[k / 2 + 1]) / 2;
      for (std::size_t j = 0; j <= 2 * ny; ++j) {
        for (std::size_t i = 0; i <= 2 * nx; ++i) {
          const auto& unknown = space_.unknown(space_.node_at(i, j, k));
          for (int c = 0; c < 3; ++c) {
            const double value = unknown[c] < 0 ? 0.0 : displacement_(unknown[c], 0);
            worst = std::max(worst, std::abs(value - (c == component ? expected : 0.0)));
          }
        }
      }
    }
    return worst / std::abs(exact.back());
  }

  /// Strain zz of the core, from the displacement of its two faces.
  double core_strain_zz() const {
    const auto [first, last] = mesh_.core_z();
    const auto height = [&](std::size_t line) {
      return displacement_(space_.unknown(space_.node_at(1, 1, 2 * line))[2], 0);
    };
    return (height(last) - height(first)) / (lines_.z[last] - lines_.z[first]);
  }

private:
  mesh::SkinMesh mesh_;
  mesh::MeshLines lines_;
  ElasticSpace space_;
  std::vector<ElasticLaw> laws_;
  linear_algebra::DenseMatrix displacement_;
};

} // namespace

std::vector<Row> patch_rows() {
  const double traction = 1e5;
  const FixedFace base{"base", Face::base, {true, true, true}};

  LayeredPatch shear({base,
                      {"end", Face::x_min, {false, false, true}},
                      {"end", Face::x_max, {false, false, true}},
                      {"symmetry plane", Face::y_max, {false, true, false}}});
  shear.load(0, traction);
  const double shear_error =
      shear.error(0, traction, [](const ElasticLaw& law) { return law.shear_modulus; });

  LayeredPatch compression({base,
                            {"end", Face::x_min, {true, false, false}},
                            {"end", Face::x_max, {true, false, false}},
                            {"side", Face::y_min, {false, true, false}},
                            {"side", Face::y_max, {false, true, false}}});
  compression.load(2, -traction);
  const double compression_error = compression.error(
      2, -traction, [](const ElasticLaw& law) { return law.oedometric_modulus(); });

  return {at_most("M1", "uniform shear through three layers: relative error", shear_error, 1e-9),
          at_most("M1", "confined compression of three layers: relative error", compression_error,
                  1e-9),
          compare("M1", "oedometric modulus of the core [GPa]",
                  -traction / compression.core_strain_zz() * 1e-9, 4.261, 5e-4)};
}

} // namespace ionskin::verification
