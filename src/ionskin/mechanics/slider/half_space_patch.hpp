// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::mechanics {

/// Integrals over a rectangle of what an elastic half-space does at a distance, with u and v from a
/// point of the rectangle to the place where it is felt and r = sqrt(u^2 + v^2).
struct PatchIntegrals {
  double inverse = 0;    ///< of 1/r [m]
  double xx = 0, yy = 0; ///< of u^2/r^3 and v^2/r^3 [m]
  double xy = 0;         ///< of u v/r^3 [m]
  double x = 0, y = 0;   ///< of u/r^2 and v/r^2 [m]
};

/// In closed form (Love 1929, DOI 10.1098/rsta.1929.0009; Johnson, Contact Mechanics, 1985, section
/// 3.3, DOI 10.1017/CBO9781139171731).
/// @param u0,u1,v0,v1 distances of the place from the ends of the rectangle, u0 < u1, v0 < v1 [m]
PatchIntegrals patch_integrals(double u0, double u1, double v0, double v1);

} // namespace ionskin::mechanics
