// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/reduction/measure_rows.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/live/skin_data.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Loads of the cells that are recovered together.
inline constexpr std::size_t loads_at_once = 8;

/// Points of the core at which the strain under unit forces is wanted, of one channel.
struct WantedStrain {
  MeasureRows rows;
  std::vector<std::size_t> points;
};

/// Strains at the points under unit forces on every cell, at every node. Of nodes that are mirror
/// images of each other one is solved.
void add_unit_strains(const mechanics::SkinModel& model, const SkinData& data,
                      const mechanics::StrainRecovery& recovery, const PlaceNodes& places,
                      const Reflections& reflections, int threads,
                      const std::vector<WantedStrain>& wanted, std::vector<ChannelMap>& maps);

} // namespace ionskin::live
