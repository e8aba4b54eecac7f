// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// The leads of metal with a sheet resistance in the preconditioner. Charge that moves along the
/// metal is diagonal in lateral modes, what the leads bring to the columns that they touch is not:
/// it is a correction of as low a rank as there are such columns (Sherman and Morrison 1950,
/// doi 10.1214/aoms/1177729893; Woodbury 1950). Without the leads the potential of the cell as a
/// whole is free; a conductance from the bottom metal to the ground, the same everywhere, holds it
/// in the modes, and the correction takes that away again.
class ContactCoupling {
public:
  ContactCoupling(const ScaledGrid& grid, const SheetElectrodes& electrodes);

  /// Hold of the bottom metal to the ground in the modes, per column and step.
  double hold(double step) const;

  /// Factorises the correction for a step.
  /// @param answers potentials of wall a, by mode, to a unit charge on wall b: answers[a][b]
  /// @param step implicit part of it
  void invert(const std::array<std::array<std::span<const float>, 2>, 2>& answers, double step);

  /// Charges by mode that the leads bring to the bottom and the top wall, less what the ground
  /// brought.
  /// @param potentials of both walls without the leads, by mode
  std::array<std::vector<float>, 2>
  charges(const std::array<std::span<const float>, 2>& potentials) const;

private:
  std::size_t touched() const { return rows_ * ends_; }
  /// Potentials of the touched columns of a wall from its modes.
  void gather(std::span<const float> modes, double* potentials) const;
  void spread(const double* charges, std::span<float> modes) const;

  const ScaledGrid& grid_;
  const SheetElectrodes& electrodes_;
  std::size_t rows_, ends_;
  std::vector<std::vector<double>> modes_x_, modes_y_; ///< of each touched end and row
  std::vector<double> charge_by_potential_; ///< unknowns: columns below, columns above, the hold
};

} // namespace ionskin::electrochemistry
