// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/vector_operations.hpp"

#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::parallel {
namespace {

constexpr std::size_t segment_length = 1024;

std::size_t segments(std::size_t length) {
  return (length + segment_length - 1) / segment_length;
}

double partial_dot(const double* a, const double* b, std::size_t begin, std::size_t end) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = begin; i < end; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

} // namespace

template <class Body>
void VectorOperations::for_segments(std::size_t length, const Body& body) const {
  team_.for_blocks(segments(length), 1, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t s = first; s < last; ++s) {
      body(s, s * segment_length, std::min(length, (s + 1) * segment_length));
    }
  });
}

double VectorOperations::sum_partial(std::size_t parts) const {
  double total = 0.0;
  for (std::size_t s = 0; s < parts; ++s) {
    total += partial_[s];
  }
  return total;
}

double VectorOperations::dot(std::span<const double> a, std::span<const double> b) {
  const std::size_t parts = segments(a.size());
  partial_.resize(std::max(partial_.size(), parts));
  for_segments(a.size(), [&](std::size_t s, std::size_t begin, std::size_t end) {
    partial_[s] = partial_dot(a.data(), b.data(), begin, end);
  });
  return sum_partial(parts);
}

double VectorOperations::orthogonalise(const std::vector<std::vector<double>>& basis,
                                       std::size_t count, std::span<double> vector,
                                       std::span<double> coefficients) {
  const std::size_t parts = segments(vector.size());
  partial_.resize(std::max(partial_.size(), parts * count));
  for_segments(vector.size(), [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t j = 0; j < count; ++j) {
      partial_[s * count + j] = partial_dot(basis[j].data(), vector.data(), begin, end);
    }
  });
  for (std::size_t j = 0; j < count; ++j) {
    coefficients[j] = 0.0;
    for (std::size_t s = 0; s < parts; ++s) {
      coefficients[j] += partial_[s * count + j];
    }
  }
  for_segments(vector.size(), [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t j = 0; j < count; ++j) {
      const double factor = coefficients[j];
      const double* base = basis[j].data();
#pragma omp simd
      for (std::size_t i = begin; i < end; ++i) {
        vector[i] -= factor * base[i];
      }
    }
    partial_[s] = partial_dot(vector.data(), vector.data(), begin, end);
  });
  return std::sqrt(sum_partial(parts));
}

double VectorOperations::norm(std::span<const double> a) {
  return std::sqrt(dot(a, a));
}

double VectorOperations::largest_magnitude(std::span<const double> a) {
  const std::size_t parts = segments(a.size());
  partial_.resize(std::max(partial_.size(), parts));
  for_segments(a.size(), [&](std::size_t s, std::size_t begin, std::size_t end) {
    double largest = 0.0, poison = 0.0;
#pragma omp simd reduction(max : largest) reduction(+ : poison)
    for (std::size_t i = begin; i < end; ++i) {
      largest = std::max(largest, std::abs(a[i]));
      poison += 0.0 * a[i]; // NaN where an entry is not finite
    }
    partial_[s] = largest + poison;
  });
  double largest = 0.0;
  for (std::size_t s = 0; s < parts; ++s) {
    largest = base::nan_max(largest, partial_[s]);
  }
  return largest;
}

void VectorOperations::add(double factor, std::span<const double> x, std::span<double> y) const {
  team_.for_blocks(x.size(), segment_length, [&](std::size_t begin, std::size_t end, std::size_t) {
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      y[i] += factor * x[i];
    }
  });
}

void VectorOperations::combine(std::span<const double> x, double factor, std::span<const double> d,
                               std::span<double> y) const {
  team_.for_blocks(x.size(), segment_length, [&](std::size_t begin, std::size_t end, std::size_t) {
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      y[i] = x[i] + factor * d[i];
    }
  });
}

void VectorOperations::scale(double factor, std::span<const double> x, std::span<double> y) const {
  team_.for_blocks(x.size(), segment_length, [&](std::size_t begin, std::size_t end, std::size_t) {
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      y[i] = factor * x[i];
    }
  });
}

} // namespace ionskin::parallel
