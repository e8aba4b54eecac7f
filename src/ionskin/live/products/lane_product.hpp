// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// Skins that are asked at once, at most.
inline constexpr std::size_t most_lanes = 4;

/// A matrix that is read once for the vectors of several skins, its lanes. The sum of a lane
/// follows the order of the columns, whatever the other lanes hold and however many there are.
class LaneProduct {
public:
  LaneProduct() = default;
  LaneProduct(std::size_t rows, std::size_t columns);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  /// Distance of the results of two lanes.
  std::size_t stride() const { return stride_; }
  float& at(std::size_t row, std::size_t column) {
    return values_[(row / tile * columns_ + column) * tile + row % tile];
  }

  /// Product with the columns that count.
  /// @param lanes 1 or `most_lanes`
  /// @param columns those that count, in the order of the sum
  /// @param factors [columns.size()][lanes]
  /// @param results [lanes][stride()]
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
