// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::units {

/// The physical dimensions that keys of a case can have.
enum class Dimension {
  number,
  length,
  angle,
  time,
  force,
  temperature,
  stress,
  diffusivity,
  permittivity,
  concentration,
  resistance,
  frequency,
  current,
  current_noise_density,
  area,
  viscosity,
  hydraulic_mobility,
  hydraulic_conductance,
  curvature,
  speed,
  capacitance,
  areal_capacitance,
  stiffness,
  damping,
  mass,
  surface_energy
};

/// Name and SI unit of a dimension, for messages and pages.
struct DimensionInfo {
  std::string name;                  ///< with its article: "a length"
  std::string si_unit;               ///< in udunits spelling; "1" for a number
  std::vector<std::string> examples; ///< usual units, the first one for messages
};

/// Information on a dimension.
const DimensionInfo& dimension_info(Dimension dimension);

/// Usual units of all dimensions, to suggest from.
std::vector<std::string> usual_units();

/// Dimensions that have a name in messages though no key has them.
const std::vector<DimensionInfo>& other_dimensions();

/// All dimensions of keys.
const std::vector<Dimension>& all_dimensions();

} // namespace ionskin::units
