// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin {

// Relations of isotropic linear elasticity [Pa].

/// E / (2 (1 + nu)) [Pa].
inline double shear_modulus(const Material& material) {
  return material.youngs_modulus / (2 * (1 + material.poissons_ratio));
}
/// E / (3 (1 - 2 nu)) [Pa].
inline double bulk_modulus(const Material& material) {
  return material.youngs_modulus / (3 * (1 - 2 * material.poissons_ratio));
}
/// Modulus of uniaxial strain, 2 G (1 - nu)/(1 - 2 nu) [Pa].
inline double oedometric_modulus(double shear, double poissons_ratio) {
  return 2 * shear * (1 - poissons_ratio) / (1 - 2 * poissons_ratio);
}

/// Oedometric modulus M of the core at constant water potential, of a case whose law moves water.
inline double drained_oedometric_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return input.water.drained_modulus > 0
             ? input.water.drained_modulus
             : oedometric_modulus(shear_modulus(core), input.water.drained_poissons_ratio);
}
/// True if a prescribed curvature bends a strip that is free to curve across: its sides then carry
/// no stress, where a wide one, between symmetry planes, keeps its width.
inline bool bends_freely(const Case& input) {
  return input.strain.kind == StrainSourceKind::prescribed && input.strain.curvature != 0 &&
         input.skin.sides == SideCondition::free;
}
/// Pressure over the swelling that it makes at constant water potential, under what the load of the
/// case holds: the strain along the skin (M), or, of a strip that bends freely, its curvature
/// alone, M - G = G/(1 - 2 nu).
inline double swelling_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return drained_oedometric_modulus(input) - (bends_freely(input) ? shear_modulus(core) : 0.0);
}
/// M_B = K_u - K_d: the undrained pore pressure over the compression that makes it (B M_B = p_u;
/// Biot's coefficient is 1, as polymer and water are incompressible).
inline double storage_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return bulk_modulus(core) - (drained_oedometric_modulus(input) - 4.0 / 3.0 * shear_modulus(core));
}
/// c_v / K = M M_B/(M + M_B), of a swelling modulus M.
inline double consolidation_modulus(const Case& input, double swelling) {
  const double storage = storage_modulus(input);
  return swelling * storage / (swelling + storage);
}
/// c_v / K of a core that keeps its extent along the skin, in which c_v is measured.
inline double consolidation_modulus(const Case& input) {
  return consolidation_modulus(input, drained_oedometric_modulus(input));
}

} // namespace ionskin
