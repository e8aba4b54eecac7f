// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::constants {

// CODATA 2018; exact in the SI since 2019.
inline constexpr double faraday = 96485.33212331;               // C/mol
inline constexpr double boltzmann = 1.380649e-23;               // J/K
inline constexpr double gas_constant = 8.31446261815;           // J/(mol K)
inline constexpr double vacuum_permittivity = 8.8541878128e-12; // F/m

/// Molar volume of liquid water at 25 degC [m3/mol] (Wagner and Pruss 2002,
/// doi 10.1063/1.1461829).
inline constexpr double molar_volume_of_water = 1.8069e-5; // m3/mol

} // namespace ionskin::constants
