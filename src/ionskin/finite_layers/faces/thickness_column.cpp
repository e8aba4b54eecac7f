// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/thickness_column.hpp"

#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <cstddef>
#include <numeric>

namespace ionskin::finite_layers {

ThicknessColumn::ThicknessColumn(const std::vector<ElasticLayer>& layers,
                                 const std::vector<ElementSizes>& elements, int degree) {
  Eigen::Index count = 0;
  for (const ElementSizes& sizes : elements) {
    count += degree * static_cast<Eigen::Index>(sizes.size());
  }
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count + 1, count + 1);
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(count + 1);
  Eigen::MatrixXd oedometric_mass = zero, lame_mass = zero, shear_mass = zero, lame_slope = zero,
                  oedometric_stiffness = zero, shear_stiffness = zero, coupling = zero;
  Eigen::Index first = 0;
  double bottom = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const ElasticLayer& layer = layers[i];
    const double total = std::accumulate(elements[i].begin(), elements[i].end(), 0.0);
    const double oedometric = layer.oedometric_modulus(), mu = layer.shear_modulus;
    for (const double share : elements[i]) {
      const double size = layer.thickness * share / total;
      const LobattoElement element(degree, size);
      const Eigen::MatrixXd mass = element.mass(), stiffness = element.stiffness(),
                            convection = element.convection();
      const auto at = Eigen::seqN(first, degree + 1);
      heights(at) = element.nodes.array() + bottom;
      oedometric_mass(at, at) += oedometric * mass;
      lame_mass(at, at) += layer.lame_lambda * mass;
      shear_mass(at, at) += mu * mass;
      lame_slope(at, at) += layer.lame_lambda * convection.transpose();
      oedometric_stiffness(at, at) += oedometric * stiffness;
      shear_stiffness(at, at) += mu * stiffness;
      coupling(at, at) += layer.lame_lambda * convection - mu * convection.transpose();
      first += degree;
      bottom += size;
    }
  }
  heights_ = heights.tail(count);
  const auto above_base = [count](const Eigen::MatrixXd& all) -> Eigen::MatrixXd {
    return all.bottomRightCorner(count, count);
  };
  oedometric_mass_ = above_base(oedometric_mass);
  lame_mass_ = above_base(lame_mass);
  shear_mass_ = above_base(shear_mass);
  lame_slope_ = above_base(lame_slope);
  oedometric_stiffness_ = above_base(oedometric_stiffness);
  shear_stiffness_ = above_base(shear_stiffness);
  coupling_ = above_base(coupling);
}

Eigen::MatrixXd ThicknessColumn::plane_strain(double wave_number) const {
  const Eigen::Index n = nodes();
  const double k = wave_number;
  Eigen::MatrixXd result(2 * n, 2 * n);
  result.topLeftCorner(n, n) = k * k * oedometric_mass_ + shear_stiffness_;
  result.bottomRightCorner(n, n) = k * k * shear_mass_ + oedometric_stiffness_;
  result.topRightCorner(n, n) = k * coupling_;
  result.bottomLeftCorner(n, n) = k * coupling_.transpose();
  return result;
}

Eigen::MatrixXd ThicknessColumn::antiplane(double wave_number) const {
  return wave_number * wave_number * shear_mass_ + shear_stiffness_;
}

} // namespace ionskin::finite_layers
