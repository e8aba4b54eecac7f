// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <array>
#include <functional>
#include <vector>

namespace ionskin::finite_layers {

/// Compliance of a face over the wave number [1/m].
using WavesOfBody = std::function<WaveCompliance(double)>;

/// About the inverse of the compliance of the cells of an even grid: of bodies without ends,
/// pressed over and over again at some distance, wave by wave. Normal and tangential parts are not
/// mixed.
class InverseWaves {
public:
  /// @param bodies whose compliances are summed
  InverseWaves(const ContactGrid& grid, const std::vector<WavesOfBody>& bodies);

  /// Normal forces that displace the cells [N].
  Eigen::MatrixXd normal(const Eigen::MatrixXd& displacement) const;
  /// Tangential forces along x and along y.
  std::array<Eigen::MatrixXd, 2>
  tangential(const std::array<Eigen::MatrixXd, 2>& displacement) const;

private:
  Eigen::MatrixXd whole(const Eigen::MatrixXd& half, double sign) const;

  bool half_;
  GridFourier fourier_;
  Eigen::ArrayXXd normal_, xx_, xy_, yy_; ///< [N/m]
};

} // namespace ionskin::finite_layers
