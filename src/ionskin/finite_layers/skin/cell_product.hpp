// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/plane/inverse_waves.hpp"
#include "ionskin/finite_layers/skin/long_waves.hpp"

#include <array>
#include <memory>
#include <vector>

namespace ionskin::finite_layers {

/// Compliance of equally large cells in a grid, given as products with forces on the cells. It
/// replaces the matrix where the cells are too many for one. Vectors are [3 cell + component] with
/// the components normal (downwards), x, y. Thread-safe.
class CellProduct {
public:
  /// Joins the parts for one position of the slider.
  /// @param inverse approximate inverse of the compliance, for preconditioning
  CellProduct(std::shared_ptr<const CellConvolution> short_waves, LongWaves long_waves,
              std::shared_ptr<const InverseWaves> inverse);

  /// Calculates the mean displacements of the cells [m] that forces cause.
  /// @param forces on the cells [N]
  std::vector<double> times(const std::vector<double>& forces) const;
  /// Estimate of the compliance of a cell against its own force, used for all cells: normal, x, y
  /// [m/N].
  const std::array<double, 3>& own() const { return own_; }
  /// Replaces normal displacements [m] by an estimate of the normal forces [N] that cause them;
  /// leaves the tangential components as they are.
  void invert_normal(std::vector<double>& values) const;
  /// Replaces tangential displacements [m] by an estimate of the tangential forces [N] that cause
  /// them; leaves the normal components as they are.
  void invert_tangential(std::vector<double>& values) const;

private:
  Eigen::MatrixXd field(const std::vector<double>& values, std::size_t component) const;
  static void set(const Eigen::MatrixXd& field, std::size_t component, std::vector<double>& values);

  std::shared_ptr<const CellConvolution> short_waves_;
  LongWaves long_waves_;
  std::shared_ptr<const InverseWaves> inverse_;
  std::array<double, 3> own_{};
};

} // namespace ionskin::finite_layers
