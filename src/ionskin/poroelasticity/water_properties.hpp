// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::poroelasticity {

/// Constants of the water in the core, derived from a case (docs/model.md (22), (23)).
struct WaterProperties {
  double streaming_coefficient = 0; ///< L_s = n_d V_w/(v F) [V/Pa]
  double drained_modulus = 0;       ///< M: `swelling_modulus` of the case [Pa]
  double storage_modulus = 0;       ///< M_B = K_u - K_d: undrained pressure over compression [Pa]
  double mobility = 0;              ///< K, at zero current [m2/(Pa s)]
  double consolidation_coefficient = 0; ///< c_v = K M M_B/(M + M_B) [m2/s]
  double dilution = 0;                  ///< theta: by how much swelling dilutes the cations [1]
  double skempton_coefficient = 0;      ///< B = M_B/K_u [1]
  double thermal_voltage = 0;           ///< V_T = R T/F [V]
  /// Share of the mean pressure that comes back as p_u where a compression is held, M_B/(M + M_B)
  /// [1].
  double held_share = 0;

  /// tau_p = h2/(pi2 c_v): the slowest decay of a pressure difference between sealed walls [s].
  double consolidation_time(double thickness) const;
  /// S = L_s M/(theta V_T): streaming over dilution [1].
  double streaming_number() const;
};

/// Derives the properties of a case whose law moves water and that has been checked.
WaterProperties derive_water_properties(const Case& input);

} // namespace ionskin::poroelasticity
