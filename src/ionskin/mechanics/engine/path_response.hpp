// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/fixed_point_columns.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

/// What the skin does in a state of a path.
struct StateResponse {
  CoreStrain strain;
  /// Largest membrane stress of each electrode layer, bottom to top [Pa].
  std::vector<double> electrode_stress;
  double equilibrium_residual = 0; ///< as of CondensedPosition::Response
};

/// Load patterns of the states of a path at one node, and what the skin does under them.
struct NodeResponse {
  std::size_t place = 0; ///< of the condensed positions
  std::array<bool, 2> reflect{};
  mesh::MeshLines lines;             ///< at the place [m]
  std::vector<std::size_t> states;   ///< that the node has a part in, ascending
  std::vector<double> weight;        ///< of the node in each of them
  std::vector<CellVector> patterns;  ///< at the place [N]; none once they are solved
  linear_algebra::DenseMatrix share; ///< of the patterns in each state
  /// LatticeDisplacement under each pattern at the place [m]: two thirds of what strains take.
  linear_algebra::FixedPointColumns core{};
  /// Of each electrode layer in the states in which the node counts, else empty [Pa].
  std::vector<std::vector<double>> electrode_stress{};
  double residual = 0; ///< of the equilibrium, the worst of the patterns
};

/// What the skin does in successive states of a path: hundreds of them in the memory of the some
/// ten load patterns that they have at each node.
class PathResponse {
public:
  /// @param core_z first and one-past-last element row of the core
  /// @param nodes in the order of their places
  PathResponse(const std::array<std::size_t, 2>& core_z, std::size_t states,
               std::vector<NodeResponse> nodes)
      : core_z_(core_z), states_(states), nodes_(std::move(nodes)) {
    for (NodeResponse& node : nodes_) { // states without any load have no pattern to solve
      node.electrode_stress.resize(node.states.size());
    }
  }

  std::size_t count() const { return states_; }
  /// Memory of what it holds of the core.
  std::size_t bytes() const;
  bool needs(std::size_t place) const;
  /// Solves the patterns of the nodes at a place.
  void solve(std::size_t place, const CondensedPosition& condensed, int threads);
  /// Of states from `first` on, all patterns solved. Strains are interpolated between the nodes,
  /// stresses and residuals the largest over the nodes that count most.
  std::vector<StateResponse> states(std::size_t first, std::size_t count, int threads) const;

private:
  std::array<std::size_t, 2> core_z_;
  std::size_t states_;
  std::vector<NodeResponse> nodes_;
};

} // namespace ionskin::mechanics
