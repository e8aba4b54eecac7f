// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/skin_data.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace ionskin::live {

/// Reduces channels of the core to modes, over samples of the contact, docs/live.md.
/// @param data with its contact, its charges and the range of its places
/// @param samples forces of the cells; their strain is that of the middle of the range, since the
/// lines of the mesh outside the footprint are elsewhere with each place, and their sums with them
/// @param channels of the history, by name; the last one drives the charges
std::vector<ChannelMap> reduce_channels(const Case& input, const SkinData& data,
                                        const std::shared_ptr<const mechanics::SkinModel>& model,
                                        const PlaceNodes& places,
                                        const std::vector<std::vector<double>>& samples,
                                        int threads, const std::vector<std::string>& channels,
                                        const base::ProgressCallback& progress);

} // namespace ionskin::live
