// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {

/// A conductor on the top face with a potential of its own.
struct TopConductor {
  std::vector<double> share; ///< of the area of each column that it covers [y][x], 0 to 1
  /// Admittance to the bottom electrode; nothing where a virtual ground holds it at that potential.
  std::optional<ScaledAdmittance> admittance;
};

/// The top face as conductors side by side. A column that two of them share has the mean of their
/// potentials, weighed by area, and gives each its share of the charge: with the matrix B of the
/// shares phi = B u and Q = B^T q, docs/model.md (62), so that charges and potentials are conjugate
/// and the capacitances between conductors are reciprocal on any grid.
class TopElectrodes {
public:
  /// Every column must be covered to the whole of its area. Throws InternalError where the
  /// conductors cannot be distinguished: one of them smaller than a column.
  explicit TopElectrodes(std::vector<TopConductor> conductors);

  std::size_t size() const { return conductors_.size(); }
  const std::vector<TopConductor>& conductors() const { return conductors_; }
  /// True if the ground holds them all: then they are one conductor but for their names.
  bool all_held() const;

  /// Sum over the columns of share times value, of each conductor: B^T x.
  std::vector<double> sums(std::span<const double> columns) const;
  /// The potential of every column, B u.
  void spread(std::span<const double> potentials, std::span<double> columns) const;
  /// The potentials of the conductors from those of the columns, the inverse of `spread`.
  std::vector<double> potentials(std::span<const double> columns) const;
  /// Adds to the columns what has the given sums.
  void add(std::span<const double> sums, std::span<double> columns) const;

private:
  std::vector<double> solved(std::vector<double> sums) const;

  std::vector<TopConductor> conductors_;
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
