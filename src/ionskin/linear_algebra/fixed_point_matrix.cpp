// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fixed_point_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace ionskin::linear_algebra {
namespace {

/// Rows expanded to double precision at a time: a block stays in the cache of one core.
constexpr int block_rows = 128;

/// Entries of the product that are summed at once, in registers. What is missing of a tile at the
/// border is filled with zeros, so that the same instructions make every entry.
constexpr int tile_rows = 8, tile_columns = 4;
constexpr int lane_rows = 4;
using Lane = double __attribute__((vector_size(lane_rows * sizeof(double))));
using Tile = std::array<std::array<double, tile_rows>, tile_columns>;

std::size_t place(int rows, int i, int j) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(j) + static_cast<std::size_t>(i);
}

/// Rows of B that are not zero, so that cells without force cost nothing.
std::vector<int> nonzero_rows(const DenseMatrix& b) {
  std::vector<int> result;
  for (int j = 0; j < b.rows; ++j) {
    bool zero = true;
    for (int k = 0; k < b.columns && zero; ++k) {
      zero = b(j, k) == 0;
    }
    if (!zero) {
      result.push_back(j);
    }
  }
  return result;
}

/// Rows of A as multiples of the units: tiles of rows one behind the other, by the columns used in
/// each.
void expand(const FixedPointMatrix& a, const std::vector<int>& used, int first, int count,
            std::vector<double>& packed) {
  std::fill(packed.begin(), packed.end(), 0.0);
  const int columns = static_cast<int>(used.size());
  for (int j = 0; j < columns; ++j) {
    const std::int32_t* from = a.values.data() + place(a.rows, first, used[j]);
    double* to = packed.data() + place(tile_rows, 0, j);
    int row = 0;
    for (; row + tile_rows <= count; row += tile_rows, to += place(tile_rows, 0, columns)) {
      for (int i = 0; i < tile_rows; ++i) { // of constant length, for the compiler
        to[i] = from[row + i];
      }
    }
    std::copy(from + row, from + count, to);
  }
}

/// B times the units of A: tiles of columns one behind the other, by the rows used in each.
std::vector<double> packed_right(const FixedPointMatrix& a, const std::vector<int>& used,
                                 const DenseMatrix& b) {
  const int tiles = (b.columns + tile_columns - 1) / tile_columns;
  const int rows = static_cast<int>(used.size());
  std::vector<double> packed(place(tiles * tile_columns, 0, rows));
  for (int k = 0; k < b.columns; ++k) {
    const int in_tile = k % tile_columns;
    double* to = packed.data() + place(k - in_tile, 0, rows) + in_tile;
    for (int j = 0; j < rows; ++j) {
      to[place(tile_columns, 0, j)] = b(used[j], k) * a.unit[used[j]];
    }
  }
  return packed;
}

void multiply_tile(const double* left, const double* right, int count, Tile& tile) {
  Lane low[tile_columns] = {}, high[tile_columns] = {};
  for (int j = 0; j < count; ++j, left += tile_rows, right += tile_columns) {
    Lane upper_rows, lower_rows;
    std::memcpy(&upper_rows, left, sizeof(Lane));
    std::memcpy(&lower_rows, left + lane_rows, sizeof(Lane));
    for (int k = 0; k < tile_columns; ++k) {
      low[k] += upper_rows * right[k];
      high[k] += lower_rows * right[k];
    }
  }
  for (int k = 0; k < tile_columns; ++k) {
    std::memcpy(tile[k].data(), &low[k], sizeof(Lane));
    std::memcpy(tile[k].data() + lane_rows, &high[k], sizeof(Lane));
  }
}

} // namespace

FixedPointMatrix::FixedPointMatrix(int row_count, int column_count)
    : rows(row_count), columns(column_count), unit(static_cast<std::size_t>(column_count)),
      values(place(row_count, 0, column_count)) {}

void FixedPointMatrix::set_column(int j, const double* column) {
  double largest = 0;
  for (int i = 0; i < rows; ++i) {
    largest = std::max(largest, std::abs(column[i]));
  }
  constexpr double steps = std::numeric_limits<std::int32_t>::max();
  unit[j] = largest / steps;
  const double scale = largest > 0 ? steps / largest : 0;
  std::int32_t* to = values.data() + place(rows, 0, j);
  for (int i = 0; i < rows; ++i) {
    to[i] = static_cast<std::int32_t>(std::lrint(column[i] * scale));
  }
}

double FixedPointMatrix::operator()(int i, int j) const {
  return unit[j] * values[place(rows, i, j)];
}

void multiply_add(const FixedPointMatrix& a, const DenseMatrix& b, DenseMatrix& c) {
  const std::vector<int> used = nonzero_rows(b);
  const int terms = static_cast<int>(used.size());
  const std::vector<double> right = packed_right(a, used, b);
  std::vector<double> left(place(block_rows, 0, terms));
  Tile tile;
  for (int first = 0; first < a.rows; first += block_rows) {
    const int count = std::min(block_rows, a.rows - first);
    expand(a, used, first, count, left);
    for (int column = 0; column < b.columns; column += tile_columns) {
      const int columns = std::min(tile_columns, b.columns - column);
      for (int row = 0; row < count; row += tile_rows) {
        multiply_tile(left.data() + place(row, 0, terms), right.data() + place(column, 0, terms),
                      terms, tile);
        const int rows = std::min(tile_rows, count - row);
        for (int k = 0; k < columns; ++k) {
          double* to = c.column(column + k) + first + row;
          for (int i = 0; i < rows; ++i) {
            to[i] += tile[k][i];
          }
        }
      }
    }
  }
}

} // namespace ionskin::linear_algebra
