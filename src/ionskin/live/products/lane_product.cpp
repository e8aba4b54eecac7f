// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/products/lane_product.hpp"

#include <cstring>

namespace ionskin::live {
namespace {

constexpr std::size_t width = 8; ///< number of floats in a vector
// Vector type of the compiler: sums of this type stay in registers, while the compiler puts a local
// array of floats into memory.
typedef float Eight __attribute__((vector_size(width * sizeof(float))));

Eight eight_from(const float* values) noexcept {
  Eight result;
  std::memcpy(&result, values, sizeof result);
  return result;
}

} // namespace

/// Multiplies as `times` does, for a number of lanes that is known at compile time.
template <std::size_t lanes>
void LaneProduct::sum_up(std::span<const std::uint32_t> columns, const float* factors,
                         float* results) const noexcept {
  constexpr std::size_t vectors = tile / width;
  for (std::size_t row = 0; row < stride_; row += tile) {
    const float* values = values_.data() + row * columns_;
    const float* factor = factors;
    Eight sums[lanes][vectors]{};
    for (const std::uint32_t column : columns) {
      Eight part[vectors];
      for (std::size_t i = 0; i < vectors; ++i) {
        part[i] = eight_from(values + column * tile + i * width);
      }
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        for (std::size_t i = 0; i < vectors; ++i) {
          sums[lane][i] += *factor * part[i];
        }
        ++factor;
      }
    }
    // The vectors are copied one by one: a copy of the whole array would put the sums into memory.
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t i = 0; i < vectors; ++i) {
        const Eight sum = sums[lane][i];
        std::memcpy(results + lane * stride_ + row + i * width, &sum, sizeof sum);
      }
    }
  }
}

LaneProduct::LaneProduct(std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns), stride_((rows + tile - 1) / tile * tile),
      values_(stride_ * columns) {}

void LaneProduct::times(std::size_t lanes, std::span<const std::uint32_t> columns,
                        const float* factors, float* results) const noexcept {
  if (lanes == 1) {
    sum_up<1>(columns, factors, results);
  } else {
    sum_up<most_lanes>(columns, factors, results);
  }
}

} // namespace ionskin::live
