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
  double slow_time = 0; ///< charging of both double layers: lambda h / (2 D) times area_ratio [s]
  double conductivity = 0;   ///< D v F^2 c0 / (R T) [S/m]
  double charge_density = 0; ///< F c0 lambda: wall charge of a fully depleted Debye length [C/m2]
  double half_thickness = 0; ///< h / (2 lambda) [1]
  /// True area of an interface over the projected one, by which it holds more than eps/lambda [1].
  double area_ratio = 1;
};

/// Scales of a core by its constants.
/// @param core_thickness h [m]
DerivedScales derive_scales(const Electrochemistry& electrochemistry, double core_thickness);

/// |k gamma| h / (2 lambda): the wall potential over the thermal voltage that a shear gamma of one
/// sign in half of the core drives; the response is linear while this stays far below 1.
double nonlinearity(const DerivedScales& scales, double coefficient, double shear);

} // namespace ionskin::electrochemistry
