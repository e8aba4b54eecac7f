// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// Displacement at the nodes of the core, its faces included: [component][z][y][x], x fastest, two
/// elements + 1 nodes along each axis [m].
using LatticeDisplacement = std::vector<double>;

/// The nodes of the core as a regular lattice. Strain needs no others.
class CoreLattice {
public:
  /// @param core_z first and one-past-last element row of the core
  CoreLattice(const ElasticSpace& space, const std::array<std::size_t, 2>& core_z);

  /// Length of a LatticeDisplacement.
  int rows() const { return static_cast<int>(unknown_.size()); }
  /// @param displacement [unknowns] [m]
  /// @param lattice [rows()]
  void gather(const double* displacement, double* lattice) const;

private:
  std::vector<int> unknown_; ///< of every lattice entry; -1 where it is held
};

/// Length of a LatticeDisplacement on a mesh of the skin.
std::size_t lattice_rows(const mesh::MeshLines& lines, const std::array<std::size_t, 2>& core_z);

/// Strain at the 2x2x2 Gauss points of the core's elements.
/// @param lines of the skin's mesh [m]
/// @param core_z first and one-past-last element row of the core
/// @param lattice as of CoreLattice [m]
CoreStrain lattice_strain(const mesh::MeshLines& lines, const std::array<std::size_t, 2>& core_z,
                          const double* lattice);

} // namespace ionskin::mechanics
