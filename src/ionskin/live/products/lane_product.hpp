// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// Largest number of skins whose products are computed at once.
inline constexpr std::size_t most_lanes = 4;

/// Matrix that is multiplied with the vectors of several skins, the lanes, while it is read from
/// memory only once. The sum of a lane follows the order of the columns, so that its result does
/// not depend on the other lanes or their number.
class LaneProduct {
public:
  LaneProduct() = default;
  /// Makes a matrix of zeros.
  LaneProduct(std::size_t rows, std::size_t columns);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  /// Distance between the results of two lanes in `results` [numbers], at least `rows()`.
  std::size_t stride() const { return stride_; }
  /// Entry of the matrix.
  float& at(std::size_t row, std::size_t column) {
    return values_[(row / tile * columns_ + column) * tile + row % tile];
  }

  /// Multiplies some columns of the matrix with the vectors of all lanes; the other columns count
  /// as multiplied with 0.
  /// @param lanes 1 or `most_lanes`
  /// @param columns indices of the columns, in the order of the sum
  /// @param factors entries of the vectors at these columns [columns.size()][lanes]
  /// @param results receives the products [lanes][stride()]
  void times(std::size_t lanes, std::span<const std::uint32_t> columns, const float* factors,
             float* results) const noexcept;

private:
  template <std::size_t lanes>
  void sum_up(std::span<const std::uint32_t> columns, const float* factors,
              float* results) const noexcept;

  static constexpr std::size_t tile = 24; ///< rows whose sums stay in registers

  std::size_t rows_ = 0, columns_ = 0, stride_ = 0;
  std::vector<float> values_; ///< [tile][column][row of the tile]
};

} // namespace ionskin::live
