// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::units {

/// Physical dimension of a value of a case file; `number` is dimensionless.
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
  voltage_noise_density,
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

/// Name and units of a dimension, for error messages and the reference of the keys.
struct DimensionInfo {
  std::string name;    ///< with its article: "a length"
  std::string si_unit; ///< SI unit in the spelling of udunits2; "1" for a number
  /// Usual units, the first of which is the example in messages; empty for dimensions of no key.
  std::vector<std::string> examples;
};

/// Looks up the name and units of a dimension.
const DimensionInfo& dimension_info(Dimension dimension);

/// Usual units of all dimensions of keys, as candidates for a misspelt unit.
std::vector<std::string> usual_units();

/// Further dimensions that no key has, such as an energy. Messages need their names to say what a
/// wrong unit measures.
const std::vector<DimensionInfo>& other_dimensions();

/// All values of `Dimension`.
const std::vector<Dimension>& all_dimensions();

} // namespace ionskin::units
