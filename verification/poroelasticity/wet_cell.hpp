// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "verification_table.hpp"

#include <functional>
#include <vector>

namespace ionskin::verification {

/// Pressure of the cases [Pa], small enough for a linear response, and the factor by which a
/// response to it is scaled to 1 MPa, the pressure of the references [1].
inline constexpr double small_pressure = 1e4, per_megapascal = 1e6 / small_pressure;

/// Case of the baseline skin under the poroelastic law with slow water: drag number 2.5, drained
/// modulus 390 MPa, mobility 2e-19 m2/(Pa s), dilution by the volume of the mixture, sealed walls.
/// The undrained core is nearly incompressible, so that closed forms hold.
Case wet_case();

/// Case of `wet_case` with protons and the water of a wet membrane: mobility 5e-17 m2/(Pa s),
/// drained modulus 200 MPa, dilution in pore water of 1/2.6 of the volume.
Case proton_case();

/// Factor 1 - (2 lambda/h) tanh(h/(2 lambda)) [1] by which the open-circuit voltage is smaller than
/// that of a thick core, since the double layers take a share of the thickness.
double layer_factor(const Case& input);

/// Strain history of one lateral column with an undrained pressure that is linear through the
/// thickness, from `bottom` to `top` [Pa]; it is switched on at the first instant and held.
/// @param time instants of the samples [s]
history::CoreHistory pressure_step_history(double bottom, double top, std::vector<double> time);

/// Strain history of a skin with an undrained pressure that varies along x and through the
/// thickness, switched on at the first instant and held.
/// @param length length of the skin [m]
/// @param columns number of lateral columns along x
/// @param pressure pressure [Pa] as a function of x [m] and of the height over the core's thickness
/// [1]
/// @param time instants of the samples [s]
history::CoreHistory held_pressure_history(double length, std::size_t columns,
                                           const std::function<double(double, double)>& pressure,
                                           std::vector<double> time);

/// Open-circuit voltage [V] of a case with a prescribed load and an open circuit, `duration` [s]
/// after its begin.
double final_voltage(Case input, double duration, const Options& options);

} // namespace ionskin::verification
