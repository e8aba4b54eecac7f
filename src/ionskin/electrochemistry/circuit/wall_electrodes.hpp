// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {

/// Indices of the walls, the faces of the core at the electrodes, in arrays that hold both.
inline constexpr std::size_t bottom_wall = 0, top_wall = 1;

/// Conductor that covers a part of a face of the core and has one potential.
struct WallConductor {
  std::vector<double> share; ///< share of each column's area that it covers [y][x], 0 to 1
  /// Scaled admittance to the ground; nothing where a virtual ground holds the conductor at
  /// potential 0.
  std::optional<ScaledAdmittance> admittance;
  std::size_t wall = top_wall; ///< face on which it lies
};

/// Conductors side by side on the top face of the core, or on both faces; a bottom face without
/// conductors is at the ground. A column that several conductors share has the mean of their
/// potentials, weighted by area, and gives each conductor its share of the charge: with the matrix
/// B of the shares phi = B u and Q = B^T q, docs/model.md (62). Charges and potentials are
/// conjugate in this way, so that the capacitances between conductors are reciprocal on any grid.
///
/// Functions of this class take fields of the walls: one value per column, first those of the
/// bottom wall, last those of the top wall. Values in between are ignored, so that a field of all
/// nodes is a field of the walls. So is a field of the columns of one wall, where both walls have
/// the same values or the bottom face has no conductors.
class WallElectrodes {
public:
  /// Makes the set of conductors. Those of a face must cover every column of it completely. Throws
  /// InternalError when the conductors cannot be distinguished, as when one of them is smaller than
  /// a column.
  explicit WallElectrodes(std::vector<WallConductor> conductors);

  std::size_t size() const { return conductors_.size(); }
  const std::vector<WallConductor>& conductors() const { return conductors_; }
  /// True if the ground holds all conductors, so that each face has one potential.
  bool all_held() const;
  /// True if the bottom face has conductors, too.
  bool on_bottom() const { return on_bottom_; }

  /// Sums share times value over the columns, for each conductor: B^T x.
  /// @param walls field of the walls, see the class
  std::vector<double> sums(std::span<const double> walls) const;
  /// Sets every column of a wall with conductors to its potential, B u.
  /// @param potentials u of the conductors
  /// @param walls field of the walls, see the class
  void spread(std::span<const double> potentials, std::span<double> walls) const;
  /// Computes the potentials of the conductors from those of the columns, the inverse of `spread`.
  /// @param walls field of the walls, see the class
  std::vector<double> potentials(std::span<const double> walls) const;
  /// Adds to the columns a field of which `sums` are the sums over the conductors.
  /// @param sums one per conductor, as the function `sums` makes them
  /// @param walls field of the walls, see the class
  void add(std::span<const double> sums, std::span<double> walls) const;

private:
  std::vector<double> solved(std::vector<double> sums) const;
  /// Index of the first column of a conductor's wall in a field of the walls.
  /// @param walls length of the field
  std::size_t first_of(std::size_t conductor, std::size_t walls) const {
    return conductors_[conductor].wall == bottom_wall ? 0 : walls - columns_;
  }

  std::vector<WallConductor> conductors_;
  std::size_t columns_;
  bool on_bottom_;
  /// Columns of each conductor, with their shares above 0.
  std::vector<std::vector<std::pair<std::size_t, double>>> covered_;
  std::vector<double> inverse_; ///< of B^T B, row by row
};

/// Equations that the circuits of the conductors add to one implicit stage, one for each: Q +
/// conductance u = start, with Q the charge of the conductor, the sum over its columns of share
/// times charge per area, and u its potential. All scaled. Infinite conductance holds u at 0.
struct ElectrodeStage {
  std::vector<double> start, conductance;

  /// True if the ground holds the conductor.
  bool holds(std::size_t conductor) const;
};

} // namespace ionskin::electrochemistry
