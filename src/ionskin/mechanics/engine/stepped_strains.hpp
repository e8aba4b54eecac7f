// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// The strains of a stepped path, recovered from the nodes block by block.
class SteppedStrains : public StrainSource {
public:
  explicit SteppedStrains(std::shared_ptr<const PositionNodes> nodes) : nodes_(std::move(nodes)) {}

  /// @returns the place of the state
  std::size_t add(const std::array<double, 2>& centre, CellVector force);

  const CoreStrain& at(std::size_t place) override;
  const std::vector<double>& largest_electrode_stress() const override { return stress_; }
  double worst_equilibrium_residual() const override { return residual_; }

private:
  std::shared_ptr<const PositionNodes> nodes_;
  std::vector<std::array<double, 2>> centres_;
  std::vector<CellVector> forces_;
  std::size_t first_ = 0; ///< of the block
  std::vector<CondensedPosition::Response> block_;
  std::vector<double> stress_;
  double residual_ = 0;
};

} // namespace ionskin::mechanics
