// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::poroelasticity {

/// Constants of the water in the core, docs/model.md (22), (23). `derive_water_properties` makes
/// them from a case.
struct WaterProperties {
  double streaming_coefficient = 0; ///< L_s = n_d V_w/(v F) [V/Pa]
  double drained_modulus = 0;       ///< M, the `swelling_modulus` of the case [Pa]
  /// M_B = K_u - K_d, undrained pore pressure over volumetric compression [Pa].
  double storage_modulus = 0;
  double mobility = 0; ///< K, permeability over viscosity at zero current [m2/(Pa s)]
  double consolidation_coefficient = 0; ///< c_v = K M M_B/(M + M_B) [m2/s]
  double dilution = 0;             ///< theta, relative dilution of the cations per swelling [1]
  double skempton_coefficient = 0; ///< B = M_B/K_u [1]
  double thermal_voltage = 0;      ///< V_T = R T/F [V]
  int valence = 1;                 ///< v of the cations [1]
  /// Share of the mean of P that adds to p_u while a compression is held, M_B/(M + M_B) [1]; 0 if
  /// none is held.
  double held_share = 0;

  /// Slowest decay time of a pressure difference between sealed walls, tau_p = h^2/(pi^2 c_v) [s].
  /// @param thickness h of the core [m]
  double consolidation_time(double thickness) const;
  /// Ratio of streaming to dilution, S = v L_s M/(theta V_T) by docs/model.md (23) [1].
  double streaming_number() const;
};

/// Derives the constants of the water from a checked case whose coupling law moves water.
WaterProperties derive_water_properties(const Case& input);

} // namespace ionskin::poroelasticity
