// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include "ionskin/finite_layers/thickness/layer_stiffness.hpp"

#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Wave number times the thickness below which a wave acts like a uniform load, even under a film
/// so stiff that it carries shear over a hundred thicknesses. The table begins there.
constexpr double uniform_below = 1e-6;
/// Wave number times the thickness of the top layer above which the layers below are not felt:
/// their effect falls like (k t)^2 exp(-2 k t).
constexpr double half_space_beyond = 22;
constexpr double intervals_of_wave_number = 160; ///< intervals of the table per unit of ln k

} // namespace

WaveCompliance wave_compliance(const std::vector<ElasticLayer>& layers, double wave_number) {
  // Stiffness of the top face of the layers assembled so far [Pa/m].
  Eigen::Matrix2d below = Eigen::Matrix2d::Zero();
  double below_across = 0;
  bool on_base = true;
  for (const ElasticLayer& layer : layers) {
    const Eigen::Matrix4d own = plane_strain_stiffness(layer, wave_number);
    const AntiplaneStiffness across = antiplane_stiffness(layer, wave_number);
    if (on_base) {
      below = own.bottomRightCorner<2, 2>();
      below_across = across.own;
    } else {
      const Eigen::Matrix2d joint = own.topLeftCorner<2, 2>() + below;
      below = own.bottomRightCorner<2, 2>() -
              own.bottomLeftCorner<2, 2>() * joint.inverse() * own.topRightCorner<2, 2>();
      below_across = across.own - across.other * across.other / (across.own + below_across);
    }
    on_base = false;
  }
  const Eigen::Matrix2d compliance = below.inverse();
  return {compliance(1, 1), compliance(0, 0), 1 / below_across,
          0.5 * (compliance(0, 1) + compliance(1, 0))};
}

WaveCompliance uniform_compliance(const std::vector<ElasticLayer>& layers) {
  WaveCompliance result;
  for (const ElasticLayer& layer : layers) {
    result.normal += layer.thickness / layer.oedometric_modulus();
    result.along += layer.thickness / layer.shear_modulus;
  }
  result.across = result.along;
  return result;
}

WaveCompliance half_space_compliance(const ElasticLayer& layer) {
  const double nu = layer.poissons_ratio(), mu = layer.shear_modulus;
  return {(1 - nu) / mu, (1 - nu) / mu, 1 / mu, (1 - 2 * nu) / (2 * mu)};
}

SurfaceCompliance::SurfaceCompliance(std::vector<ElasticLayer> layers)
    : layers_(std::move(layers)), uniform_(uniform_compliance(layers_)),
      half_space_(half_space_compliance(layers_.back())), first_(uniform_below / thickness()),
      last_(half_space_beyond / layers_.back().thickness) {
  const double range = std::log(last_ / first_);
  const auto intervals = static_cast<std::size_t>(std::ceil(intervals_of_wave_number * range));
  const double step = range / static_cast<double>(intervals);
  Eigen::Array4Xd values(4, static_cast<Eigen::Index>(intervals) + 1);
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double k = first_ * std::exp(step * static_cast<double>(i));
    const WaveCompliance at = wave_compliance(layers_, k);
    values.col(static_cast<Eigen::Index>(i)) << k * at.normal, k * at.along, k * at.across,
        k * at.mixed;
  }
  mixed_slope_ = values(3, 0) / (first_ * first_);
  table_ = CubicTable(std::log(first_), step, std::move(values));
}

WaveCompliance SurfaceCompliance::at(double wave_number) const {
  if (wave_number <= first_) {
    WaveCompliance long_wave = uniform_; // relative error (k H)^2, H: thickness
    long_wave.mixed = mixed_slope_ * wave_number;
    return long_wave;
  }
  if (wave_number >= last_) {
    return {half_space_.normal / wave_number, half_space_.along / wave_number,
            half_space_.across / wave_number, half_space_.mixed / wave_number};
  }
  const CubicTable::Values at = table_.at(std::log(wave_number)) / wave_number;
  return {at(0), at(1), at(2), at(3)};
}

double SurfaceCompliance::thickness() const {
  return std::accumulate(
      layers_.begin(), layers_.end(), 0.0,
      [](double sum, const ElasticLayer& layer) { return sum + layer.thickness; });
}

} // namespace ionskin::finite_layers
