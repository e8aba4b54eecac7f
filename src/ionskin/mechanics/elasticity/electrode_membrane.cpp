// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/electrode_membrane.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Average of d/dx_r of the shape functions over the unit cube, by node: the difference of the
/// averages over two opposite faces, by Simpson's rule.
std::array<std::array<double, 3>, element_nodes> average_derivatives() {
  constexpr std::array<double, 3> simpson{1.0 / 6, 4.0 / 6, 1.0 / 6}, difference{-1, 0, 1};
  std::array<std::array<double, 3>, element_nodes> result{};
  for (std::size_t node = 0; node < element_nodes; ++node) {
    const std::array<std::size_t, 3> at{node % 3, node / 3 % 3, node / 9};
    for (std::size_t r = 0; r < 3; ++r) {
      result[node][r] = difference[at[r]] * simpson[at[(r + 1) % 3]] * simpson[at[(r + 2) % 3]];
    }
  }
  return result;
}

} // namespace

double von_mises_stress(const ElasticLaw& law, const double* strain) {
  const double mean = (strain[0] + strain[1] + strain[2]) / 3;
  double squares = 0;
  for (int c = 0; c < 3; ++c) {
    squares += (strain[c] - mean) * (strain[c] - mean) + 2 * strain[3 + c] * strain[3 + c];
  }
  return 2 * law.shear_modulus * std::sqrt(1.5 * squares);
}

ElectrodeMembrane::ElectrodeMembrane(const ElasticSpace& space, const mesh::MeshLines& lines,
                                     const std::vector<ElasticLaw>& law_of_row,
                                     const std::vector<std::size_t>& layer_of_row,
                                     const std::array<std::size_t, 2>& core_z)
    : space_(space), lines_(lines), columns_(space.elements()[0] * space.elements()[1]) {
  for (std::size_t row = 0; row < layer_of_row.size(); ++row) {
    if (row >= core_z[0] && row < core_z[1]) {
      continue;
    }
    if (row > 0 && !layers_.empty() && layer_of_row[row] == layer_of_row[row - 1]) {
      layers_.back().last_row = row;
    } else {
      layers_.push_back({row, row, law_of_row[row]});
    }
  }
}

void ElectrodeMembrane::average_strain(const double* displacement, double* average) const {
  static const auto derivative = average_derivatives();
  std::fill_n(average, rows(), 0.0);
  for (const Layer& layer : layers_) {
    const double thickness = lines_.z[layer.last_row + 1] - lines_.z[layer.first_row];
    for (std::size_t row = layer.first_row; row <= layer.last_row; ++row) {
      const double part = (lines_.z[row + 1] - lines_.z[row]) / thickness;
      for (std::size_t column = 0; column < columns_; ++column) {
        const std::size_t e = column + columns_ * row;
        const std::array<double, 3> size = element_size(space_, lines_, e);
        std::array<std::array<double, 3>, 3> gradient{}; // [component][axis]
        for (std::size_t node = 0; node < element_nodes; ++node) {
          const std::array<int, 3>& unknown = space_.unknown(space_.nodes(e)[node]);
          for (std::size_t c = 0; c < 3; ++c) {
            const double value = unknown[c] < 0 ? 0.0 : displacement[unknown[c]];
            for (std::size_t r = 0; r < 3; ++r) {
              gradient[c][r] += derivative[node][r] * value;
            }
          }
        }
        double* strain = average + 6 * column;
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
          strain[c] += part * gradient[c][c] / size[c];
          strain[3 + c] += part * 0.5 * (gradient[a][b] / size[b] + gradient[b][a] / size[a]);
        }
      }
    }
    average += 6 * columns_;
  }
}

std::vector<double> ElectrodeMembrane::largest_stress(const double* average) const {
  std::vector<double> result;
  for (const Layer& layer : layers_) {
    double largest = 0;
    for (std::size_t column = 0; column < columns_; ++column, average += 6) {
      largest = base::larger(largest, von_mises_stress(layer.law, average));
    }
    result.push_back(largest);
  }
  return result;
}

} // namespace ionskin::mechanics
