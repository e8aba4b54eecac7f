// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/history/core_history.hpp"

#include <array>
#include <functional>
#include <vector>

namespace ionskin::handover {

/// Strain components xx, yy, zz, yz, xz, xy at the points of `mechanics::CoreStrain`, each
/// [z][y][x] [1]. Components that the case does not need are empty.
using PointStrain = std::array<std::vector<double>, 6>;

/// Sums the strains of the states of a combination with their weights.
PointStrain strain_at_points(const StateCombination& combination);

/// Rule that makes one channel of the strain history from the strain at the points.
struct ChannelRule {
  const char* name; ///< name of the channel, from `history::channel_name`
  /// Calculates the scalar at each point, [z][y][x], in the unit of the channel.
  std::function<std::vector<double>(const PointStrain&)> at_points;
};

/// Lists the channels of a case: the shear by its measure and, if its coupling law includes water
/// transport, the dilation.
std::vector<ChannelRule> channel_rules(const Case& input);

/// Throws SolverError when a field of a channel is not finite. Without this check the ion transport
/// would fail far from the cause.
/// @param time instant of the field, for the message [s]
void require_finite(const history::StrainField& field, const Case& input, double time);

} // namespace ionskin::handover
