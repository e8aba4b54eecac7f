// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_skin.hpp"
#include "ionskin/finite_layers/fields/field_target.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Band of wave numbers whose modes are summed in a box of their own, docs/model.md (59).
struct WaveBand {
  /// Position of the box for a slider that is centred in it [m]. The box keeps its size and stays
  /// within the skin, as it ends at faces that are nearer than the waves reach.
  /// @param centre of the footprint, from the skin's corner [m]
  PlaneBox box(const std::array<double, 2>& centre) const;

  double skin_length = 0, skin_width = 0; ///< [m]
  double length = 0, width = 0;           ///< of the box [m]
  PlaneWaves waves;
};

/// Divides all waves into bands: the modes of the whole skin carry the longest waves, and each
/// further band has shorter waves in a smaller box. Waves that are felt beneath a thin electrode
/// would otherwise fill a box as wide as the core is thick.
/// @param split between the waves of the whole skin and all shorter ones
/// @param last wave number beyond which there are no waves [1/m]
std::vector<WaveBand> wave_bands(const FieldSkin& skin, const ContactGrid& cells,
                                 const WaveSplit& split, double last);

} // namespace ionskin::finite_layers
