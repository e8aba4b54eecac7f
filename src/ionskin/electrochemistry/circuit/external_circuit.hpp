// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <optional>

namespace ionskin::electrochemistry {

/// Conductance between the electrodes as the time integrator wants it: 1/R in units of
/// F c0 lambda A / (tau R T/(v F)), 0 for an open circuit; nothing where the electrodes' potentials
/// are given (short circuit, amplifier).
/// The load R obeys voltage = phi_top - phi_bottom = -R I, with I = d((Q_top - Q_bottom)/2)/dt the
/// difference current, positive into the top electrode. The common current returns through the
/// ground and does not pass the load.
/// @param area of an electrode [m2]
std::optional<double> circuit_conductance(const Readout& readout, const DerivedScales& scales,
                                          double area);

} // namespace ionskin::electrochemistry
