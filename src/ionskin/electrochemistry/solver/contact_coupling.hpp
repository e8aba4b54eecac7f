// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Leads of metal with a sheet resistance, as a part of the preconditioner. Charge that moves along
/// the metal is diagonal in lateral modes, charge that the leads bring to the columns that they
/// touch is not: it is a correction of as low a rank as there are such columns (Sherman and
/// Morrison 1950, doi 10.1214/aoms/1177729893; Woodbury 1950). Without the leads the potential of
/// the cell as a whole would be free; in the modes a conductance from the bottom metal to the
/// ground, the same everywhere, holds it, and the correction removes that again.
class ContactCoupling {
public:
  ContactCoupling(const ScaledGrid& grid, const SheetElectrodes& electrodes);

  /// Conductance per column from the bottom metal to the ground, times the implicit part of the
  /// step, that the modes contain.
  /// @param step implicit part of the time step [relaxation times]
  double hold(double step) const;

  /// Factorises the correction for a time step.
  /// @param answers potential of wall a by a unit charge on wall b, for every mode:
  ///   answers[a][b][mode]
  /// @param step implicit part of the time step [relaxation times]
  void invert(const std::array<std::array<std::span<const float>, 2>, 2>& answers, double step);

  /// Computes the charges that the leads bring to the bottom and to the top wall, less those that
  /// the ground brought, [bottom, top][mode].
  /// @param potentials of both walls without the leads, [bottom, top][mode]
  std::array<std::vector<float>, 2>
  charges(const std::array<std::span<const float>, 2>& potentials) const;

private:
  std::size_t touched() const { return rows_ * ends_; }
  /// Adds the potentials of the touched columns of a wall, from its modes.
  void gather(std::span<const float> modes, double* potentials) const;
  void spread(const double* charges, std::span<float> modes) const;

  const ScaledGrid& grid_;
  const SheetElectrodes& electrodes_;
  std::size_t rows_, ends_;
  std::vector<std::vector<double>> modes_x_, modes_y_; ///< cosines in each touched end and row
  /// Matrix from potentials to charges of the touched columns of the bottom wall, those of the top
  /// wall, and the ground.
  std::vector<double> charge_by_potential_;
};

} // namespace ionskin::electrochemistry
