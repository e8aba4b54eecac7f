// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

namespace ionskin::electrochemistry {

ElectrodeCharges::ElectrodeCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge)
    : grid_(grid), fixed_charge_(fixed_charge), terminals_(grid) {}

double ElectrodeCharges::step_error(std::span<const double> change, double column_share,
                                    NewtonKrylov& solver, const ChargeNorm& norm) const {
  return norm.of_change(solver.damped_sums(change, norm.weights()), column_share);
}

ElectrodeReading ElectrodeCharges::reading(std::span<const double> settled,
                                           const TransportState& state) const {
  const auto ion_rate = std::span(state.rate).first(settled.size());
  return {{terminals_.of_ions(settled, 1.0), terminals_.of_ions(ion_rate, 0.0)}, {}, {}};
}

} // namespace ionskin::electrochemistry
