// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/grading.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mesh {
namespace {

std::vector<double> accumulate(const std::vector<double>& sizes, double length) {
  std::vector<double> line{0.0};
  double total = 0;
  for (const double size : sizes) {
    total += size;
  }
  for (const double size : sizes) {
    line.push_back(line.back() + size * length / total);
  }
  line.back() = length;
  return line;
}

/// Limit of the elements on a line, far above any mesh that can be solved.
constexpr std::size_t most_elements = 100'000;

[[noreturn]] void refuse_mesh(double length, double first) {
  throw UserError(
      fmt::format("the mesh would have more than {} elements along {:.3g} m, which begin "
                  "with {:.3g} m\n  = thin layers and small contacts ask for small "
                  "elements: make the layers thicker, slider and skin smaller, or the "
                  "preload larger",
                  most_elements, length, first));
}

double geometric_sum(double ratio, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum = 1 + ratio * sum;
  }
  return sum;
}

double geometric_sum_slope(double ratio, std::size_t count) {
  double sum = 0, slope = 0;
  for (std::size_t i = 0; i < count; ++i) {
    slope = sum + ratio * slope;
    sum = 1 + ratio * sum;
  }
  return slope;
}

} // namespace

std::vector<double> graded_line(double length, double first, double growth, double largest,
                                const EdgeZone& zone) {
  std::vector<double> sizes;
  double size = first, total = 0;
  while (total < length * (1 - 1e-9)) {
    if (sizes.size() >= most_elements || !(size > 0)) {
      refuse_mesh(length, first);
    }
    sizes.push_back(size);
    total += size;
    size = std::min(size * growth, std::max(first, total < zone.width ? zone.largest : largest));
  }
  return accumulate(sizes, length);
}

double geometric_ratio(double length, double first, std::size_t count) {
  if (count < 2 || length <= first) {
    throw InternalError("geometric_ratio needs two elements and a length above the first size");
  }
  const double target = length / first;
  double low = 0, high = 2;
  while (geometric_sum(high, count) < target) {
    high *= 2;
  }
  double ratio = 0.5 * (low + high);
  // Newton kept inside the bracket: the result must be smooth in the length to rounding.
  for (int i = 0; i < 100; ++i) {
    const double excess = geometric_sum(ratio, count) - target;
    (excess > 0 ? high : low) = ratio;
    double next = ratio - excess / geometric_sum_slope(ratio, count);
    if (next <= low || next >= high) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - ratio) <= 1e-16 * ratio) {
      break;
    }
    ratio = next;
  }
  return ratio;
}

std::vector<double> geometric_line(double length, double first, std::size_t count) {
  if (count == 1) {
    return {0.0, length};
  }
  const double ratio = geometric_ratio(length, first, count);
  std::vector<double> sizes{first};
  while (sizes.size() < count) {
    sizes.push_back(sizes.back() * ratio);
  }
  return accumulate(sizes, length);
}

std::vector<double> growing_line(double length, double growth, std::size_t count) {
  std::vector<double> sizes;
  double size = 1;
  for (std::size_t i = 0; i < count; ++i, size *= growth) {
    sizes.push_back(size);
  }
  return accumulate(sizes, length);
}

std::vector<double> two_sided_line(double length, double growth, std::size_t count) {
  std::vector<double> sizes(count);
  for (std::size_t i = 0; i < count; ++i) {
    sizes[i] = std::pow(growth, static_cast<double>(std::min(i, count - 1 - i)));
  }
  return accumulate(sizes, length);
}

std::size_t geometric_count(double length, double first, double growth) {
  std::size_t count = 1;
  while (geometric_sum(growth, count) * first < length * (1 - 1e-9)) {
    if (++count > most_elements / 10) { // each term costs the sum of all before
      refuse_mesh(length, first);
    }
  }
  return count;
}

std::vector<double> reversed(const std::vector<double>& line) {
  std::vector<double> result(line.rbegin(), line.rend());
  for (double& value : result) {
    value = line.back() - value;
  }
  return result;
}

void append(std::vector<double>& lines, const std::vector<double>& line) {
  const double start = lines.back();
  for (std::size_t i = 1; i < line.size(); ++i) {
    lines.push_back(start + line[i]);
  }
}

} // namespace ionskin::mesh
