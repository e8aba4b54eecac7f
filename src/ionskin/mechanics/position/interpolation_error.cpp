// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_error.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ionskin::mechanics {
namespace {

double inner_product(const std::shared_ptr<const CoreStrain>& a,
                     const std::shared_ptr<const CoreStrain>& b) {
  if (!a || !b) {
    return 0;
  }
  double sum = 0;
  for (std::size_t c = 0; c < a->component.size(); ++c) {
    const auto &in_a = a->component[c], &in_b = b->component[c];
    sum = std::inner_product(in_a.begin(), in_a.end(), in_b.begin(), sum);
  }
  return sum;
}

/// Values at the Chebyshev points of the second kind of the polynomial through given nodes; shape
/// [points, nodes].
std::vector<std::vector<double>> chebyshev_values(const std::vector<NodeStrain>& nodes) {
  std::vector<double> places;
  for (const NodeStrain& node : nodes) {
    places.push_back(node.at);
  }
  const double begin = places.front(), length = places.back() - begin;
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double angle =
        std::numbers::pi * static_cast<double>(i) / static_cast<double>(nodes.size() - 1);
    values.push_back(
        interpolation_weights(places, begin + length * std::pow(std::cos(angle / 2), 2)));
  }
  return values;
}

/// By which the values at the nodes give the Chebyshev coefficients; shape [orders, nodes].
std::vector<std::vector<double>> coefficient_weights(const std::vector<NodeStrain>& nodes) {
  const std::vector<std::vector<double>> values = chebyshev_values(nodes);
  const std::size_t count = nodes.size(), last = count - 1;
  std::vector<std::vector<double>> weights(count, std::vector<double>(count));
  for (std::size_t order = 0; order < count; ++order) {
    for (std::size_t i = 0; i < count; ++i) {
      const double ends = (i == 0 || i == last ? 0.5 : 1) * (order == 0 || order == last ? 0.5 : 1);
      const double cosine =
          std::cos(std::numbers::pi * static_cast<double>(order * i) / static_cast<double>(last));
      for (std::size_t node = 0; node < count; ++node) {
        weights[order][node] += 2 * ends * cosine / static_cast<double>(last) * values[i][node];
      }
    }
  }
  return weights;
}

} // namespace

std::vector<double> chebyshev_norms(const std::vector<NodeStrain>& nodes) {
  const std::size_t count = nodes.size();
  std::vector<double> gram(count * count);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      gram[count * i + j] = gram[count * j + i] = inner_product(nodes[i].strain, nodes[j].strain);
    }
    largest = base::larger(largest, gram[count * i + i]);
  }
  std::vector<double> norms;
  for (const std::vector<double>& weights : coefficient_weights(nodes)) {
    double square = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        square += weights[i] * gram[count * i + j] * weights[j];
      }
    }
    norms.push_back(largest == 0 ? 0.0 : std::sqrt(base::larger(0.0, square) / largest));
  }
  return norms;
}

InterpolationError interpolation_error(const std::vector<double>& norms) {
  constexpr double slowest = 0.9; // that extrapolation makes sense for
  const std::size_t count = norms.size();
  const double last = norms[count - 1], before = norms[count - 2];
  InterpolationError error{0, slowest};
  // Two orders together, lest one that symmetry leaves out looks like decay; the mean has no part.
  if (count > 3 && before + norms[count - 3] > 0) {
    error.decay = std::min(slowest, (last + before) / (before + norms[count - 3]));
  } else if (count == 3 && before > 0) {
    error.decay = std::min(slowest, last / before);
  } else if (count == 2 && before > 0) {
    error.decay = std::min(slowest, std::sqrt(last / before)); // the mean is large: safely slow
  }
  const double largest = count > 2 ? base::larger(last, error.decay * before) : last;
  error.estimate = 2 * largest * error.decay / (1 - error.decay);
  return error;
}

double interpolation_tolerance(Preset preset) {
  return preset == Preset::fine ? 2e-6 : 5e-5;
}

std::size_t wanted_node_count(std::size_t count, const InterpolationError& error,
                              double tolerance) {
  if (!(error.estimate > tolerance) || count >= most_interpolation_nodes) {
    return count;
  }
  const double more = std::log(tolerance / error.estimate) / std::log(error.decay);
  const double pairs = std::ceil((static_cast<double>(count) + more) / 2);
  return std::min(most_interpolation_nodes,
                  std::max(count + 1 + (count + 1) % 2, 2 * static_cast<std::size_t>(pairs)));
}

} // namespace ionskin::mechanics
