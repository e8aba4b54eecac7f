// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_error.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

std::vector<double> places_of(const std::vector<NodeStrain>& nodes) {
  std::vector<double> places;
  for (const NodeStrain& node : nodes) {
    places.push_back(node.at);
  }
  return places;
}

/// Values at the Chebyshev points of the second kind of the polynomial through given nodes; shape
/// [points, nodes].
std::vector<std::vector<double>> chebyshev_values(const std::vector<NodeStrain>& nodes) {
  const std::vector<double> places = places_of(nodes);
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

/// Largest distance between each Chebyshev polynomial that the nodes do not hold, of twice their
/// number, and the polynomial through its values at the nodes.
std::vector<double> aliasing(const std::vector<NodeStrain>& nodes) {
  const std::size_t count = nodes.size(), points = 16 * count;
  const std::vector<double> places = places_of(nodes);
  const double begin = places.front(), length = places.back() - begin;
  const auto angle_of = [&](double place) {
    return 2 * std::acos(std::sqrt(std::clamp((place - begin) / length, 0.0, 1.0)));
  };
  std::vector<double> worst(2 * count);
  for (std::size_t i = 0; i <= points; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const std::vector<double> weights =
        interpolation_weights(places, begin + length * std::pow(std::cos(angle / 2), 2));
    for (std::size_t k = 0; k < worst.size(); ++k) {
      const auto order = static_cast<double>(count + k);
      double difference = std::cos(order * angle);
      for (std::size_t node = 0; node < count; ++node) {
        difference -= weights[node] * std::cos(order * angle_of(places[node]));
      }
      worst[k] = std::max(worst[k], std::abs(difference));
    }
  }
  return worst;
}

/// From one order to the next, of two orders together, lest one that symmetry leaves out looks like
/// decay.
double decay_of(const std::vector<double>& norms) {
  constexpr double slowest = 0.9; // that extrapolation makes sense for
  const std::size_t count = norms.size();
  const double last = norms[count - 1], before = norms[count - 2];
  double square = slowest * slowest;
  if (count > 4 && norms[count - 3] + norms[count - 4] > 0) {
    square = (last + before) / (norms[count - 3] + norms[count - 4]);
  } else if (count == 4 && before + norms[1] > 0) { // the mean, order 0, has no part
    square = std::pow((last + before) / (before + norms[1]), 2);
  } else if (count == 3 && before > 0) {
    square = std::pow(last / before, 2);
  } else if (count == 2 && before > 0) {
    square = last / before; // the mean is large: safely slow
  }
  return std::min(slowest, std::sqrt(square));
}

} // namespace

std::vector<double> chebyshev_norms(const std::vector<NodeStrain>& nodes) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd weights(count, count); // [nodes, orders]
  for (Eigen::Index order = 0; const std::vector<double>& row : coefficient_weights(nodes)) {
    weights.col(order++) = Eigen::Map<const Eigen::VectorXd>(row.data(), count);
  }
  Eigen::RowVectorXd of_nodes = Eigen::RowVectorXd::Zero(count), of_orders = of_nodes; // squares
  const auto given =
      std::ranges::find_if(nodes, [](const NodeStrain& node) { return node.strain != nullptr; });
  if (given == nodes.end()) {
    return std::vector<double>(nodes.size());
  }
  constexpr std::size_t most_points = 1024; // at once: they stay in the processor's cache
  for (std::size_t c = 0; c < given->strain->component.size(); ++c) {
    const std::size_t points = given->strain->component[c].size();
    for (std::size_t begin = 0; begin < points; begin += most_points) {
      const auto size = static_cast<Eigen::Index>(std::min(most_points, points - begin));
      Eigen::MatrixXd values = Eigen::MatrixXd::Zero(size, count);
      for (Eigen::Index node = 0; node < count; ++node) {
        if (const CoreStrain* strain = nodes[static_cast<std::size_t>(node)].strain.get()) {
          values.col(node) =
              Eigen::Map<const Eigen::VectorXd>(strain->component[c].data() + begin, size);
        }
      }
      of_nodes += values.colwise().squaredNorm();
      of_orders += (values * weights).colwise().squaredNorm();
    }
  }
  const double largest = std::accumulate(of_nodes.begin(), of_nodes.end(), 0.0, base::larger);
  std::vector<double> norms;
  for (const double square : of_orders) {
    norms.push_back(largest == 0 ? 0.0 : std::sqrt(square / largest));
  }
  return norms;
}

InterpolationError interpolation_error(const std::vector<NodeStrain>& nodes) {
  constexpr double safety = 1.5; // of the decay, which is no law
  const std::vector<double> norms = chebyshev_norms(nodes);
  InterpolationError error{0, decay_of(norms)};
  double before = norms.size() > 2 ? norms[norms.size() - 2] : 0, last = norms.back(), largest = 0;
  for (const double distance : aliasing(nodes)) {
    const double next = base::larger(error.decay * last, error.decay * error.decay * before);
    error.estimate += safety * distance * next;
    largest = std::max(largest, distance);
    before = std::exchange(last, next);
  }
  error.estimate += safety * largest * last * error.decay / (1 - error.decay);
  return error;
}

double interpolation_tolerance(Preset preset, bool over_rectangle) {
  if (preset == Preset::fine) {
    return over_rectangle ? 2e-5 : 2e-6; // positions along both axes multiply
  }
  return over_rectangle ? 5e-4 : 2.5e-4;
}

std::size_t wanted_node_count(std::size_t count, const InterpolationError& error, double tolerance,
                              bool in_pairs) {
  if (!(error.estimate > tolerance) || count >= most_interpolation_nodes) {
    return count;
  }
  const double more = std::ceil(std::log(tolerance / error.estimate) / std::log(error.decay));
  const std::size_t wanted =
      count + std::max<std::size_t>(1, static_cast<std::size_t>(std::min(more, 1e3)));
  return std::min(most_interpolation_nodes, in_pairs ? wanted + wanted % 2 : wanted);
}

} // namespace ionskin::mechanics
