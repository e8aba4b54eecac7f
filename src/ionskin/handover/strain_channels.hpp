// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/history/core_history.hpp"

#include <array>
#include <functional>
#include <vector>

namespace ionskin::handover {

/// Six components xx, yy, zz, yz, xz, xy of the strain at the points of mechanics::CoreStrain, each
/// [z][y][x]; empty of those that the case does not read [1].
using PointStrain = std::array<std::vector<double>, 6>;

/// Strain of a combination of states.
PointStrain strain_at_points(const StateCombination& combination);

/// A channel that the handover makes, by its value at the points of a strain.
struct ChannelRule {
  const char* name;
  std::function<std::vector<double>(const PointStrain&)> at_points;
};

/// The shear by the measure of the case and, where its coupling law moves water, the dilation.
std::vector<ChannelRule> channel_rules(const Case& input);

/// Throws SolverError where a field of a channel is not finite, which the ion transport would find
/// far from its cause.
void require_finite(const history::StrainField& field, const Case& input, double time);

} // namespace ionskin::handover
