// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <cmath>

namespace ionskin::verification {

/// Rows M1: waves so long that they do not vary over the thickness, against the exact columns of
/// the layers.
std::vector<Row> patch_rows() {
  constexpr double wave_number = 1e-2; // [1/m]
  const std::vector<finite_layers::ElasticLayer> layers =
      finite_layers::elastic_layers(baseline_case().skin);
  double shear = 0, compression = 0;
  for (const finite_layers::ElasticLayer& layer : layers) {
    shear += layer.thickness / layer.shear_modulus;
    compression += layer.thickness / layer.oedometric_modulus();
  }
  const finite_layers::WaveCompliance wave = finite_layers::wave_compliance(layers, wave_number);
  return {at_most("M1", "uniform shear through three layers: relative error",
                  std::max(std::abs(wave.along / shear - 1), std::abs(wave.across / shear - 1)),
                  1e-9),
          at_most("M1", "confined compression of three layers: relative error",
                  std::abs(wave.normal / compression - 1), 1e-9),
          compare("M1", "oedometric modulus of the core [GPa]",
                  layers[1].oedometric_modulus() * 1e-9, 4.261, 5e-4)};
}

} // namespace ionskin::verification
