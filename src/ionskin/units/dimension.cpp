// SPDX-License-Identifier: Apache-2.0
#include "ionskin/units/dimension.hpp"

#include <map>

namespace ionskin::units {

namespace {

const std::map<Dimension, DimensionInfo>& table() {
  static const std::map<Dimension, DimensionInfo> rows = {
      {Dimension::number, {"a pure number", "1", {"1", "%"}}},
      {Dimension::length, {"a length", "m", {"mm", "um", "nm", "cm", "m"}}},
      {Dimension::angle, {"an angle", "rad", {"deg", "rad", "mrad"}}},
      {Dimension::time, {"a time", "s", {"s", "ms", "us", "min", "h"}}},
      {Dimension::force, {"a force", "N", {"N", "mN", "kN"}}},
      {Dimension::temperature, {"a temperature", "K", {"degC", "K", "degF"}}},
      {Dimension::stress, {"a stress", "Pa", {"MPa", "GPa", "kPa", "Pa", "N/mm2"}}},
      {Dimension::diffusivity, {"a diffusivity", "m2/s", {"m2/s", "cm2/s", "um2/s"}}},
      {Dimension::permittivity, {"a permittivity", "F/m", {"F/m", "mF/m", "nF/m"}}},
      {Dimension::concentration,
       {"a concentration", "mol/m3", {"mol/m3", "mol/L", "mmol/L", "M", "mM"}}},
      {Dimension::resistance, {"a resistance", "ohm", {"MOhm", "kOhm", "Ohm", "GOhm"}}},
      {Dimension::frequency, {"a frequency", "Hz", {"Hz", "kHz", "mHz", "MHz"}}},
      {Dimension::current, {"an electric current", "A", {"mA", "uA", "nA", "A"}}},
      {Dimension::current_noise_density,
       {"a current noise density", "A/sqrt(Hz)", {"pA/sqrt(Hz)", "nA/sqrt(Hz)", "fA/sqrt(Hz)"}}},
      {Dimension::voltage_noise_density,
       {"a voltage noise density", "V/sqrt(Hz)", {"nV/sqrt(Hz)", "uV/sqrt(Hz)"}}},
      {Dimension::area, {"an area", "m2", {"m2", "nm2", "um2"}}},
      {Dimension::viscosity, {"a viscosity", "Pa s", {"mPa s", "Pa s"}}},
      {Dimension::hydraulic_mobility,
       {"a hydraulic mobility", "m2/(Pa s)", {"m2/(Pa s)", "um2/(Pa s)"}}},
      {Dimension::hydraulic_conductance,
       {"a hydraulic conductance", "m/(Pa s)", {"m/(Pa s)", "um/(Pa s)"}}},
      {Dimension::curvature, {"a curvature", "1/m", {"1/m", "1/mm", "1/cm"}}},
      {Dimension::speed, {"a speed", "m/s", {"mm/s", "um/s", "m/s"}}},
      {Dimension::areal_capacitance,
       {"a capacitance per area", "F/m2", {"F/m2", "uF/cm2", "mF/cm2"}}},
      {Dimension::capacitance, {"a capacitance", "F", {"pF", "nF", "uF", "mF", "F"}}},
      {Dimension::stiffness, {"a stiffness", "N/m", {"N/m", "N/mm", "kN/m"}}},
      {Dimension::damping, {"a damping", "N s/m", {"N s/m", "mN s/m"}}},
      {Dimension::mass, {"a mass", "kg", {"g", "mg", "kg"}}},
      {Dimension::surface_energy, {"an energy per area", "J/m2", {"mJ/m2", "J/m2"}}},
  };
  return rows;
}

} // namespace

const DimensionInfo& dimension_info(Dimension dimension) {
  return table().at(dimension);
}

std::vector<std::string> usual_units() {
  std::vector<std::string> units;
  for (const auto& [dimension, info] : table())
    units.insert(units.end(), info.examples.begin(), info.examples.end());
  return units;
}

const std::vector<DimensionInfo>& other_dimensions() {
  static const std::vector<DimensionInfo> rows = {
      {"a volume", "m3", {}}, {"an energy", "J", {}},
      {"a power", "W", {}},   {"an electric charge", "C", {}},
      {"a voltage", "V", {}}, {"an amount of substance", "mol", {}}};
  return rows;
}

const std::vector<Dimension>& all_dimensions() {
  static const std::vector<Dimension> dimensions = [] {
    std::vector<Dimension> all;
    for (const auto& [dimension, info] : table())
      all.push_back(dimension);
    return all;
  }();
  return dimensions;
}

} // namespace ionskin::units
