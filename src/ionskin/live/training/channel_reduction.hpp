// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"
#include "ionskin/live/training/full_run.hpp"
#include "ionskin/live/training/place_nodes.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace ionskin::live {

/// Values at the nodes as a mean and the modes that are larger than a part of it.
PlaceMap place_map(const PlaceNodes& places, const std::vector<std::vector<float>>& nodes,
                   double negligible);

/// The compliance of the contact cells over the nodes.
PlaceMap reduce_compliance(const mechanics::SkinModel& model, const PlaceNodes& places);

/// Reduces channels of runs on one mesh: proper orthogonal decomposition of each at the Gauss
/// points, weighted with their volumes, then the points from which its modes are told best (QR with
/// pivoting, Drmac and Gugercin 2016, doi 10.1137/15M1019271).
/// @param channels of the history, by name
std::vector<ChannelMap> reduce_channels(const std::vector<FullRun>& runs,
                                        const std::shared_ptr<const mechanics::SkinModel>& model,
                                        const PlaceNodes& places, int threads,
                                        const std::vector<std::string>& channels);

} // namespace ionskin::live
