// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <optional>

namespace ionskin::electrochemistry {

/// Admittance of a readout circuit in the units of the time integrator: d(q + capacitance U)/dt =
/// -conductance U, with q half of the difference of the electrodes' charges per area [F c0 lambda]
/// and U the voltage, top minus bottom [R T/(v F)].
struct ScaledAdmittance {
  double conductance = 0; ///< 1/R [F c0 lambda A / (tau R T/(v F))]; 0 is open
  double capacitance = 0; ///< C [F c0 lambda A / (R T/(v F))]

  bool operator==(const ScaledAdmittance&) const = default;
};

/// Converts an admittance to the units of the time integrator.
/// @param area area to which the charges refer, of an electrode or of a column [m2]
ScaledAdmittance scaled_admittance(const circuits::Admittance& admittance,
                                   const DerivedScales& scales, double area);

/// Makes the admittance of the circuit between the electrodes in the units of the time integrator;
/// nothing where the potentials of the electrodes are given (short circuit, amplifier).
/// @param area of an electrode [m2]
std::optional<ScaledAdmittance> scaled_admittance(const Readout& readout,
                                                  const DerivedScales& scales, double area);

} // namespace ionskin::electrochemistry
