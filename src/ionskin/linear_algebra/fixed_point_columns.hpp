// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ionskin::linear_algebra {

/// Columns that are kept to be read whole, in five bytes an entry: 40-bit multiples of the column's
/// unit. Rounding is 9.1e-13 of the largest magnitude in the column, so that derivatives of a field
/// keep their digits, too. FixedPointMatrix is shorter, and multiplies.
class FixedPointColumns {
public:
  FixedPointColumns() = default;
  FixedPointColumns(std::size_t row_count, std::size_t column_count);

  /// Memory of one entry.
  static constexpr std::size_t bytes_per_entry = sizeof(std::int32_t) + sizeof(std::uint8_t);

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return unit_.size(); }
  /// @param column [rows]
  void set(std::size_t j, const double* column);
  /// @param column [rows]
  void get(std::size_t j, double* column) const;

private:
  std::size_t rows_ = 0;
  std::vector<double> unit_;       ///< [columns]
  std::vector<std::int32_t> high_; ///< upper bits of each multiple, column-major
  std::vector<std::uint8_t> low_;  ///< its lowest eight
};

} // namespace ionskin::linear_algebra
