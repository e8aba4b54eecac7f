// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// Row sets E1, E2, E6 and C1: identities that hold to rounding, in one and in three dimensions.
std::vector<Row> identity_rows(const Options& options);
/// Row set E3: charge after a small shear step, linear through the thickness, against its closed
/// form, and the observed orders of convergence.
std::vector<Row> linear_step_rows(const Options& options);
/// Row set E4: impedance of the cell with blocking electrodes over ten decades of frequency against
/// its closed form.
std::vector<Row> impedance_rows();
/// Row set E4 in time: the linear cell in series with a load, and open.
std::vector<Row> circuit_rows(const Options& options);
/// Row set E5: wall charge of nonlinear double layers.
std::vector<Row> double_layer_rows(const Options& options);
/// Row set E7, and for ions of finite size E9: a manufactured solution of the nonlinear equations
/// in three dimensions, and the observed orders of convergence.
std::vector<Row> manufactured_rows(const Options& options);
/// Row set C5: error estimate that the program reports for its currents, against their true error.
std::vector<Row> error_estimate_rows(const Options& options);
/// Row set E8: in the linear limit, the laterally averaged response against the response to the
/// averaged shear.
std::vector<Row> lateral_average_rows(const Options& options);

/// Row set E9: ions of finite size (steric model): double layers, spectrum, linear and dilute
/// limits, conservation.
std::vector<Row> steric_rows(const Options& options);

/// Row set E10: taxels with circuits of their own against waves along a linear strip, conservation
/// and reciprocity.
std::vector<Row> taxel_rows(const Options& options);

/// Row set E11: electrodes with a sheet resistance against a line of resistors and cells, its
/// limits, and conservation.
std::vector<Row> sheet_rows(const Options& options);

/// Row set E12: the cell with blocking electrodes, with and without a capacitance of its
/// interfaces, in frequency and time.
std::vector<Row> interface_rows(const Options& options);

/// Row set E13: thermal noise of a resistor, and of the cell beside a capacitor, against Johnson
/// and Nyquist.
std::vector<Row> noise_rows();

/// Row set E14: crossing lines of a crossbar against a bridge of conductances between them, limits,
/// reciprocity, conservation, and the skin with both faces exchanged.
std::vector<Row> crossbar_rows(const Options& options);

} // namespace ionskin::verification
