// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/tangential_correction.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

/// Smallest principal value of a cell's `by_trial` along which its force is an unknown; below it,
/// the force stays at its limit [1].
constexpr double follows = 1e-3;
/// Squared residual of the conjugate gradients at which they stop, over the first one [1].
constexpr float enough = 1e-6f;
constexpr int most_iterations = 60; ///< largest number of iterations of the conjugate gradients

float dot(const std::vector<float>& a, const std::vector<float>& b, std::size_t count) {
  std::array<float, 8> part{}; // independent sums, which a processor overlaps
  std::size_t i = 0;
  for (; i + part.size() <= count; i += part.size()) {
    for (std::size_t k = 0; k < part.size(); ++k) {
      part[k] += a[i + k] * b[i + k];
    }
  }
  for (; i < count; ++i) {
    part[0] += a[i] * b[i];
  }
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

} // namespace

TangentialCorrection::TangentialCorrection(std::size_t cells)
    : directions_(2 * cells), matrix_(4 * cells * cells), change_(2 * cells), residual_(2 * cells),
      search_(2 * cells), product_(2 * cells) {}

void TangentialCorrection::add(std::size_t cell, double own,
                               const std::array<std::array<double, 2>, 2>& by_trial,
                               const std::array<double, 2>& defect) noexcept {
  // Principal values and directions of `by_trial`.
  const double mean = (by_trial[0][0] + by_trial[1][1]) / 2,
               half = (by_trial[0][0] - by_trial[1][1]) / 2, mixed = by_trial[0][1],
               radius = std::hypot(half, mixed), angle = 0.5 * std::atan2(mixed, half);
  const double x = std::cos(angle), y = std::sin(angle);
  for (const auto& [value, along_x, along_y] :
       {std::array{mean + radius, x, y}, std::array{mean - radius, -y, x}}) {
    if (value > follows) {
      const double share = std::min(1.0, value);
      directions_[count_++] = {
          cell,
          static_cast<float>(along_x),
          static_cast<float>(along_y),
          static_cast<float>(own * (1 / share - 1)),
          static_cast<float>(own * (along_x * defect[0] + along_y * defect[1]) / share),
          static_cast<float>(own / share)};
    }
  }
}

void TangentialCorrection::solve() noexcept {
  const auto scaled = [&](std::size_t i) { return residual_[i] / matrix_[i * count_ + i]; };
  float product = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    change_[i] = 0;
    residual_[i] = directions_[i].slip;
    search_[i] = scaled(i);
    product += residual_[i] * search_[i];
  }
  const float first = product;
  for (int iteration = 0; iteration < most_iterations && product > enough * first; ++iteration) {
    std::fill_n(product_.begin(), count_, 0.0f);
    for (std::size_t j = 0; j < count_; ++j) {
      const float* column = matrix_.data() + j * count_;
      for (std::size_t i = 0; i < count_; ++i) {
        product_[i] += search_[j] * column[i];
      }
    }
    const float curvature = dot(search_, product_, count_);
    if (!(curvature > 0)) {
      return;
    }
    const float step = product / curvature;
    float next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      change_[i] += step * search_[i];
      residual_[i] -= step * product_[i];
      next += residual_[i] * scaled(i);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      search_[i] = scaled(i) + next / product * search_[i];
    }
    product = next;
  }
}

bool TangentialCorrection::factor() noexcept {
  for (std::size_t j = 0; j < count_; ++j) {
    float* own = matrix_.data() + j * count_;
    if (!(own[j] > 0)) {
      return false;
    }
    const float inverse = 1 / std::sqrt(own[j]);
    for (std::size_t i = j; i < count_; ++i) {
      own[i] *= inverse;
    }
    for (std::size_t k = j + 1; k < count_; ++k) {
      float* right = matrix_.data() + k * count_;
      const float left = own[k];
      for (std::size_t i = k; i < count_; ++i) {
        right[i] -= left * own[i];
      }
    }
  }
  return true;
}

/// Solves with the Cholesky factors, in place in `change_`.
void TangentialCorrection::substitute() noexcept {
  for (std::size_t j = 0; j < count_; ++j) {
    const float* column = matrix_.data() + j * count_;
    const float value = change_[j] /= column[j];
    for (std::size_t i = j + 1; i < count_; ++i) {
      change_[i] -= value * column[i];
    }
  }
  for (std::size_t j = count_; j-- > 0;) {
    const float* column = matrix_.data() + j * count_;
    float value = change_[j];
    for (std::size_t i = j + 1; i < count_; ++i) {
      value -= column[i] * change_[i];
    }
    change_[j] = value / column[j];
  }
}

std::array<double, 2> TangentialCorrection::change(std::size_t i) const {
  const Direction& direction = directions_[i];
  return {static_cast<double>(change_[i] * direction.x),
          static_cast<double>(change_[i] * direction.y)};
}

} // namespace ionskin::live
