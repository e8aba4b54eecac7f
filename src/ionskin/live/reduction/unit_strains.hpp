// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/reduction/measure_rows.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Number of load cases whose strain is recovered together.
inline constexpr std::size_t loads_at_once = 8;

/// Points of the core at which the strain under unit forces is needed for one channel, and the
/// combinations of its components.
struct WantedStrain {
  MeasureRows rows;
  std::vector<std::size_t> points;
};

/// Computes the strains at some points under unit forces on every contact cell, with the slider at
/// every node of positions, and stores them as `strain` of the maps. Solves only one of several
/// nodes that are mirror images of each other.
/// @param recovery of the strain from cell forces
/// @param places nodes
/// @param wanted points and combinations of each channel
/// @param maps of the channels, whose `strain` and `rows_per_point` are set
void add_unit_strains(const mechanics::SkinModel& model, const SkinData& data,
                      const mechanics::StrainRecovery& recovery, const PlaceNodes& places,
                      const Reflections& reflections, int threads,
                      const std::vector<WantedStrain>& wanted, std::vector<ChannelMap>& maps);

} // namespace ionskin::live
