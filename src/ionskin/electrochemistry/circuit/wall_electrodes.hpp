// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {

/// The faces of the core, as indices of arrays.
inline constexpr std::size_t bottom_wall = 0, top_wall = 1;

/// A conductor on a face of the core with a potential of its own.
struct WallConductor {
  std::vector<double> share; ///< of the area of each column that it covers [y][x], 0 to 1
  /// Admittance to the ground; nothing where a virtual ground holds it at that potential.
  std::optional<ScaledAdmittance> admittance;
  std::size_t wall = top_wall;
};

/// The top face, or both faces, as conductors side by side; a bottom face without conductors is at
/// the ground. A column that two of them share has the mean of their potentials, weighed by area,
/// and gives each its share of the charge: with the matrix B of the shares phi = B u and Q = B^T q,
/// docs/model.md (62), so that charges and potentials are conjugate and the capacitances between
/// conductors are reciprocal on any grid.
///
/// A field of the walls holds one value per column of either: the first are those of the bottom
/// wall, the last those of the top wall. The field of all nodes is one, and so is that of the
/// columns alone where both walls have the same values or the bottom face has no conductors.
class WallElectrodes {
public:
  /// Every column of a face with conductors must be covered to the whole of its area. Throws
  /// InternalError where the conductors cannot be distinguished: one of them smaller than a column.
  explicit WallElectrodes(std::vector<WallConductor> conductors);

  std::size_t size() const { return conductors_.size(); }
  const std::vector<WallConductor>& conductors() const { return conductors_; }
  /// True if the ground holds them all: then each face is one conductor but for their names.
  bool all_held() const;
  /// True if the bottom face is cut, too.
  bool on_bottom() const { return on_bottom_; }

  /// Sum over the columns of share times value, of each conductor: B^T x.
  /// @param walls field of the walls; so are the others below
  std::vector<double> sums(std::span<const double> walls) const;
  /// The potential of every column of a wall with conductors, B u.
  void spread(std::span<const double> potentials, std::span<double> walls) const;
  /// The potentials of the conductors from those of the columns, the inverse of `spread`.
  std::vector<double> potentials(std::span<const double> walls) const;
  /// Adds to the columns a field whose sums over the conductors are these.
  void add(std::span<const double> sums, std::span<double> walls) const;

private:
  std::vector<double> solved(std::vector<double> sums) const;
  /// Index of the first column of a conductor's wall.
  std::size_t first_of(std::size_t conductor, std::size_t walls) const {
    return conductors_[conductor].wall == bottom_wall ? 0 : walls - columns_;
  }

  std::vector<WallConductor> conductors_;
  std::size_t columns_;
  bool on_bottom_;
  std::vector<std::vector<std::pair<std::size_t, double>>> covered_; ///< columns, shares above 0
  std::vector<double> inverse_;                                      ///< of B^T B, row by row
};

/// Equations that the circuits of the conductors add to one implicit stage: Q + conductance u =
/// start, with Q the charge of a conductor and u its potential; Q is the sum over its columns of
/// charge per area, all scaled. Infinite conductance holds u at 0.
struct ElectrodeStage {
  std::vector<double> start, conductance;

  bool holds(std::size_t conductor) const;
};

} // namespace ionskin::electrochemistry
