// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::electrochemistry {

/// Scales of the Poisson-Nernst-Planck system in the core, docs/model.md (17), from which every
/// dimensionless group follows.
struct DerivedScales {
  double thermal_voltage = 0; ///< R T / F [V]
  double potential_scale = 0; ///< R T / (v F): changes c by a factor e [V]
  double debye_length = 0;    ///< sqrt(eps R T / (v F^2 c0)) [m]
  double relaxation_time = 0; ///< lambda^2 / D [s]
  /// Time in which both double layers charge through the core, lambda h / (2 D) times `area_ratio`
  /// [s].
  double slow_time = 0;
  double conductivity = 0;   ///< D v F^2 c0 / (R T) [S/m]
  double charge_density = 0; ///< F c0 lambda: wall charge of a fully depleted Debye length [C/m2]
  double half_thickness = 0; ///< h / (2 lambda) [1]
  /// True area of an interface over the projected one, by which its capacitance exceeds eps/lambda
  /// [1].
  double area_ratio = 1;
};

/// Computes the scales of a core from its constants.
/// @param core_thickness h [m]
DerivedScales derive_scales(const Electrochemistry& electrochemistry, double core_thickness);

/// Computes the nonlinearity |k gamma| h / (2 lambda area_ratio) [1]: the wall potential over the
/// thermal voltage that a shear gamma of one sign in half of the core drives. The response is
/// linear while this stays far below 1.
/// @param coefficient k [1]
/// @param shear gamma [1]
double nonlinearity(const DerivedScales& scales, double coefficient, double shear);

} // namespace ionskin::electrochemistry
