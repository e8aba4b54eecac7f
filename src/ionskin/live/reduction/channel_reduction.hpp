// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace ionskin::live {

/// Reduces channels (scalar fields over the core) to modes, from samples of the contact;
/// docs/live-training.md describes the method.
/// @param data trained model so far, with its contact, charges and range of positions
/// @param places positions of the slider at which the fits are made
/// @param samples forces of the cells [sample][3 cells] [N]. The modes are made with the slider in
/// the middle of its range: mesh lines outside the contact lie elsewhere at each position, and sums
/// over the mesh would change with them
/// @param channels names of channels of the history; the last one drives the charges
/// @returns one map for each channel
std::vector<ChannelMap> reduce_channels(const Case& input, const SkinData& data,
                                        const std::shared_ptr<const mechanics::SkinModel>& model,
                                        const PlaceNodes& places,
                                        const std::vector<std::vector<double>>& samples,
                                        int threads, const std::vector<std::string>& channels,
                                        const base::ProgressCallback& progress);

} // namespace ionskin::live
