// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// E1, E2, E6 and C1: identities that hold to rounding, in one and in three dimensions.
std::vector<Row> identity_rows(const Options& options);
/// E3: linear step through the thickness against its closed form, and the observed orders.
std::vector<Row> linear_step_rows(const Options& options);
/// E4: impedance of the blocking cell over ten decades against its closed form.
std::vector<Row> impedance_rows();
/// E4 in time: the linear cell behind a load and open.
std::vector<Row> circuit_rows(const Options& options);
/// E5: wall charge of nonlinear double layers.
std::vector<Row> double_layer_rows(const Options& options);
/// E7: an exact solution of the nonlinear equations in 3D, and the observed orders.
std::vector<Row> manufactured_rows(const Options& options);
/// C5: the program's own estimate of the error of its currents against the truth.
std::vector<Row> error_estimate_rows(const Options& options);
/// E8: in the linear limit the laterally averaged response is the response of the averaged shear.
std::vector<Row> lateral_average_rows(const Options& options);

/// E9: ions of finite size: double layers, spectrum, linear and dilute limits, conservation.
std::vector<Row> steric_rows(const Options& options);

/// E10: taxels with circuits of their own against waves along a linear strip, conservation and
/// reciprocity.
std::vector<Row> taxel_rows(const Options& options);

/// E11: metal with a sheet resistance against a line of resistors and cells, its limits, and
/// conservation.
std::vector<Row> sheet_rows(const Options& options);

/// E12: the blocking cell with and without a capacitance of its interfaces, in frequency and time.
std::vector<Row> interface_rows(const Options& options);

/// E13: thermal noise of a resistor, and of the cell beside a capacitor, against Johnson and
/// Nyquist.
std::vector<Row> noise_rows();

/// E14: crossing lines against a bridge of conductances between them, their limits, reciprocity,
/// conservation, and both faces in exchange.
std::vector<Row> crossbar_rows(const Options& options);

} // namespace ionskin::verification
