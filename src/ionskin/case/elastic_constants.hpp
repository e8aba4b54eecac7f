// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin {

// Moduli that follow from the constants of a case by isotropic linear elasticity.

/// Shear modulus G = E / (2 (1 + nu)) [Pa].
inline double shear_modulus(const Material& material) {
  return material.youngs_modulus / (2 * (1 + material.poissons_ratio));
}
/// Bulk modulus E / (3 (1 - 2 nu)) [Pa].
inline double bulk_modulus(const Material& material) {
  return material.youngs_modulus / (3 * (1 - 2 * material.poissons_ratio));
}
/// Oedometric modulus, that of uniaxial strain, 2 G (1 - nu)/(1 - 2 nu) [Pa].
/// @param shear shear modulus G [Pa]
inline double oedometric_modulus(double shear, double poissons_ratio) {
  return 2 * shear * (1 - poissons_ratio) / (1 - 2 * poissons_ratio);
}

/// Drained oedometric modulus M of the core, at constant water potential [Pa]. Only for a case
/// whose coupling law moves water.
inline double drained_oedometric_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return input.water.drained_modulus > 0
             ? input.water.drained_modulus
             : oedometric_modulus(shear_modulus(core), input.water.drained_poissons_ratio);
}
/// True if a prescribed curvature bends a narrow strip with free sides, which carry no stress. A
/// wide strip, between symmetry planes, keeps its width instead.
inline bool bends_freely(const Case& input) {
  return input.strain.kind == StrainSourceKind::prescribed && input.strain.curvature != 0 &&
         input.skin.sides == SideCondition::free;
}
/// Swelling modulus of the core [Pa]: pressure over the swelling that it causes at constant water
/// potential. It is the drained oedometric modulus M where the load holds the strain along the
/// skin, and M - G = G/(1 - 2 nu) for a strip that bends freely, where only the curvature is held.
inline double swelling_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return drained_oedometric_modulus(input) - (bends_freely(input) ? shear_modulus(core) : 0.0);
}
/// Storage modulus M_B = K_u - K_d of the core [Pa], docs/model.md (22): undrained pore pressure
/// over the volumetric compression that causes it. Biot's coefficient is 1, as polymer and water
/// are incompressible.
inline double storage_modulus(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  return bulk_modulus(core) - (drained_oedometric_modulus(input) - 4.0 / 3.0 * shear_modulus(core));
}
/// Consolidation modulus c_v / K = M M_B/(M + M_B) [Pa], the factor between the hydraulic mobility
/// K and the consolidation coefficient c_v, docs/model.md (22).
/// @param swelling swelling modulus M of the core [Pa]
inline double consolidation_modulus(const Case& input, double swelling) {
  const double storage = storage_modulus(input);
  return swelling * storage / (swelling + storage);
}
/// Consolidation modulus c_v / K [Pa] of a core whose strain along the skin is held, the condition
/// under which c_v is measured. M is the drained oedometric modulus.
inline double consolidation_modulus(const Case& input) {
  return consolidation_modulus(input, drained_oedometric_modulus(input));
}

} // namespace ionskin
