// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include "ionskin/base/constants.hpp"

#include <cmath>

namespace ionskin::electrochemistry {

namespace {

/// Capacitance of a double layer at rest per true area [F/m2]; ions of finite size make the layer
/// thicker.
double layer_capacitance(const Electrochemistry& electrochemistry, double debye_length) {
  const double share =
      electrochemistry.ion_model == IonModel::steric
          ? electrochemistry.resting_concentration() / electrochemistry.largest_concentration
          : 0.0;
  return electrochemistry.permittivity * std::sqrt(1.0 - share) / debye_length;
}

} // namespace

DerivedScales derive_scales(const Electrochemistry& electrochemistry, double core_thickness) {
  const double charge_concentration =
      constants::faraday * electrochemistry.fixed_charge_concentration;
  DerivedScales scales;
  scales.thermal_voltage =
      constants::gas_constant * electrochemistry.temperature / constants::faraday;
  scales.potential_scale = scales.thermal_voltage / electrochemistry.valence;
  scales.debye_length =
      std::sqrt(electrochemistry.permittivity * scales.potential_scale / charge_concentration);
  scales.relaxation_time = scales.debye_length * scales.debye_length / electrochemistry.diffusivity;
  scales.slow_time = scales.debye_length * core_thickness / (2.0 * electrochemistry.diffusivity);
  scales.conductivity =
      electrochemistry.diffusivity * charge_concentration / scales.potential_scale;
  scales.charge_density = charge_concentration * scales.debye_length;
  scales.half_thickness = core_thickness / (2.0 * scales.debye_length);
  if (electrochemistry.interface_capacitance > 0) {
    scales.area_ratio = electrochemistry.interface_capacitance /
                        layer_capacitance(electrochemistry, scales.debye_length);
    scales.slow_time *= scales.area_ratio;
  }
  return scales;
}

double nonlinearity(const DerivedScales& scales, double coefficient, double shear) {
  return std::abs(coefficient * shear) * scales.half_thickness / scales.area_ratio;
}

} // namespace ionskin::electrochemistry
