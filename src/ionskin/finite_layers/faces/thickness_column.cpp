// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/thickness_column.hpp"

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
    const double bottom_of_layer = bottom;
    thickness_.push_back(layer.thickness);
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
      parts_.push_back({element, i, bottom - bottom_of_layer, size, first});
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

ThicknessColumn::AtLevel ThicknessColumn::at(const DepthLevel& level) const {
  const Eigen::Index count = nodes() + 1;
  Eigen::RowVectorXd value = Eigen::RowVectorXd::Zero(count), slope = value;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (part.layer != level.layer) {
      continue;
    }
    const auto own = Eigen::seqN(part.first, part.element.nodes.size());
    if (!level.height) {
      const double share = part.size / thickness_[part.layer];
      value(own) += share * part.element.means();
      slope(own) += share * part.element.mean_slopes();
      continue;
    }
    const bool last = i + 1 == parts_.size() || parts_[i + 1].layer != part.layer;
    if (*level.height < part.bottom + part.size || last) {
      value(own) = part.element.values_at(*level.height - part.bottom);
      slope(own) = part.element.slopes_at(*level.height - part.bottom);
      break;
    }
  }
  return {value.tail(nodes()), slope.tail(nodes())};
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
