// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "verification_table.hpp"

#include <functional>
#include <vector>

namespace ionskin::verification {

/// Pressure of the cases, small enough for a linear response, to which references are scaled from
/// 1 MPa [Pa].
inline constexpr double small_pressure = 1e4, per_megapascal = 1e6 / small_pressure;

/// The baseline skin under the poroelastic law with slow water: drag number 2.5, drained modulus
/// 390 MPa, mobility 2e-19 m2/(Pa s), dilution by the volume of the mixture, sealed walls. The
/// undrained core is all but incompressible, so that closed forms hold.
Case wet_case();

/// The wet case with protons and the water of a wet membrane: mobility 5e-17 m2/(Pa s), drained
/// modulus 200 MPa, dilution in pore water of 1/2.6 of the volume.
Case proton_case();

/// 1 - (2 lambda/h) tanh(h/(2 lambda)): of the open-circuit voltage of a thick core, the double
/// layers' share of the thickness is missing.
double layer_factor(const Case& input);

/// One column at rest whose undrained pressure is linear through the thickness from `bottom` to
/// `top` [Pa], switched on at the first instant and held.
/// @param time samples [s]
history::CoreHistory pressure_step_history(double bottom, double top, std::vector<double> time);

/// An undrained pressure on `columns` cells along x, held from the first instant.
/// @param length of the skin [m]
/// @param pressure of the place along x and of the height over the core's thickness [Pa]
history::CoreHistory held_pressure_history(double length, std::size_t columns,
                                           const std::function<double(double, double)>& pressure,
                                           std::vector<double> time);

/// Open-circuit voltage of a case with a prescribed load after `duration` [s] [V].
double final_voltage(Case input, double duration, const Options& options);

} // namespace ionskin::verification
