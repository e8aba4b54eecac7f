// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/finite_layers/plane/inverse_waves.hpp"
#include "ionskin/finite_layers/skin/long_waves.hpp"

#include <array>
#include <memory>
#include <vector>

namespace ionskin::finite_layers {

/// The compliance of the cells of an even grid as products with forces on them, for cells too many
/// for a matrix. Vectors are [3 cell + component]: normal, x, y. Thread-safe.
class CellProduct {
public:
  CellProduct(std::shared_ptr<const CellConvolution> short_waves, LongWaves long_waves,
              std::shared_ptr<const InverseWaves> inverse);

  /// Displacements by forces [m].
  std::vector<double> times(const std::vector<double>& forces) const;
  /// About that of any cell by its own force: normal, x, y [m/N].
  const std::array<double, 3>& own() const { return own_; }
  /// About the forces that make displacements, of one kind by themselves, in their place [N].
  void invert_normal(std::vector<double>& values) const;
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
