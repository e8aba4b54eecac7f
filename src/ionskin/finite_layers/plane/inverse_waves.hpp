// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <array>
#include <functional>
#include <vector>

namespace ionskin::finite_layers {

/// Compliance of the face of a body as a function of the wave number [1/m].
using WavesOfBody = std::function<WaveCompliance(double)>;

/// Approximate inverse of the compliance of equally large cells in a grid, used to precondition an
/// iterative solver. It treats the bodies as having no ends and the load as repeated periodically,
/// so that it inverts the compliance wave by wave. Coupling between normal and tangential
/// components is left out.
class InverseWaves {
public:
  /// Inverts the summed compliance of all bodies for each wave.
  /// @param bodies such as the skin and a soft slider
  InverseWaves(const ContactGrid& grid, const std::vector<WavesOfBody>& bodies);

  /// Estimates the normal forces on the cells that cause given normal displacements, [column, row]
  /// [N].
  /// @param displacement downwards, [column, row] [m]
  Eigen::MatrixXd normal(const Eigen::MatrixXd& displacement) const;
  /// Estimates the tangential forces along x and along y that cause given tangential displacements,
  /// each [column, row] [N].
  /// @param displacement along x and along y, each [column, row] [m]
  std::array<Eigen::MatrixXd, 2>
  tangential(const std::array<Eigen::MatrixXd, 2>& displacement) const;

private:
  Eigen::MatrixXd whole(const Eigen::MatrixXd& half, double sign) const;

  bool half_;
  GridFourier fourier_;
  /// Inverse compliances, [wave along y, wave along x] [N/m].
  Eigen::ArrayXXd normal_, xx_, xy_, yy_;
};

} // namespace ionskin::finite_layers
