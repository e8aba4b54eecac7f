// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <optional>

namespace ionskin::electrochemistry {

/// Admittance that the circuit asks of the time integrator: d(q + capacitance U)/dt = -conductance
/// U, with q half the difference of the electrodes' charges per area and U the voltage, all scaled.
struct ScaledAdmittance {
  double conductance = 0; ///< 1/R in units of F c0 lambda A / (tau R T/(v F)); 0 is open
  double capacitance = 0; ///< C in units of F c0 lambda A / (R T/(v F))

  bool operator==(const ScaledAdmittance&) const = default;
};

/// An admittance in the units of the integrator.
/// @param area that charges are taken over [m2]
ScaledAdmittance scaled_admittance(const circuits::Admittance& admittance,
                                   const DerivedScales& scales, double area);

/// The admittance between the electrodes; nothing where their potentials are given (short circuit,
/// amplifier).
/// @param area of an electrode [m2]
std::optional<ScaledAdmittance> scaled_admittance(const Readout& readout,
                                                  const DerivedScales& scales, double area);

} // namespace ionskin::electrochemistry
