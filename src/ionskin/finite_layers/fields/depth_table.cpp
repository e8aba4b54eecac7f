// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/depth_table.hpp"

#include <cmath>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Nodes of the table per unit of the logarithm. At k d = 10, with the depth d, the error of the
/// cubics is 1e-4 of the remaining amplitude exp(-10).
constexpr double nodes_per_unit = 40;

} // namespace

DepthTable::DepthTable(const std::vector<ElasticLayer>& layers,
                       const std::vector<DepthLevel>& levels, double longest,
                       std::vector<double> cutoffs)
    : cutoffs_(std::move(cutoffs)), first_(std::log(longest)) {
  const double last = std::log(*std::ranges::max_element(cutoffs_));
  nodes_ = static_cast<Eigen::Index>(std::ceil((last - first_) * nodes_per_unit)) + 4;
  step_ = 1 / nodes_per_unit;
  values_.resize(8, nodes_ * static_cast<Eigen::Index>(levels.size()));
  for (Eigen::Index node = 0; node < nodes_; ++node) {
    const double k = std::exp(first_ + static_cast<double>(node) * step_);
    const std::vector<DepthStrain> strains = depth_strain(layers, k, levels);
    for (std::size_t level = 0; level < strains.size(); ++level) {
      const DepthStrain& at = strains[level];
      values_.col(node + nodes_ * static_cast<Eigen::Index>(level)) << at.stretch_by_along,
          at.stretch_by_normal, at.rise_by_along, at.rise_by_normal, at.shear_by_along,
          at.shear_by_normal, at.twist, at.across;
    }
  }
}

} // namespace ionskin::finite_layers
