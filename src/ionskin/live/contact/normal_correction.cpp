// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/normal_correction.hpp"

#include <algorithm>

namespace ionskin::live {

NormalCorrection::NormalCorrection(std::size_t cells) : matrix_(cells * cells), cells_(cells) {}

bool NormalCorrection::is_of(std::span<const std::size_t> cells) const noexcept {
  return count_ > 0 && std::ranges::equal(cells, std::span(cells_).first(count_));
}

void NormalCorrection::take(std::span<const std::size_t> cells) noexcept {
  count_ = cells.size();
  std::ranges::copy(cells, cells_.begin());
}

bool NormalCorrection::factor() noexcept {
  for (std::size_t j = 0; j < count_; ++j) {
    float* own = matrix_.data() + j * count_;
    for (std::size_t k = 0; k < j; ++k) {
      const float* left = matrix_.data() + k * count_;
      const float upper = own[k];
      for (std::size_t i = k + 1; i < count_; ++i) {
        own[i] -= upper * left[i];
      }
    }
    if (!(own[j] > 0)) {
      forget();
      return false;
    }
    const float inverse = 1 / own[j];
    for (std::size_t i = j + 1; i < count_; ++i) {
      own[i] *= inverse;
    }
  }
  return true;
}

void NormalCorrection::solve(std::span<float> values) const noexcept {
  for (std::size_t j = 0; j < count_; ++j) {
    const float* column = matrix_.data() + j * count_;
    for (std::size_t i = j + 1; i < count_; ++i) {
      values[i] -= values[j] * column[i];
    }
  }
  for (std::size_t j = count_; j-- > 0;) {
    const float* column = matrix_.data() + j * count_;
    values[j] /= column[j];
    for (std::size_t i = 0; i < j; ++i) {
      values[i] -= values[j] * column[i];
    }
  }
}

} // namespace ionskin::live
