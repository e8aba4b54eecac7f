// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace ionskin::readout {

/// Share of the contact that may slip while the contact counts as sticking, and by which the stuck
/// share falls at the first micro-slip. Below it cells of the mesh decide.
inline constexpr double micro_slip_share = 0.05;
/// Stuck share below which the contact counts as slipping fully.
inline constexpr double full_slip_share = 0.01;

/// State of the contact, by the numbers of the column `slip_state`.
enum class SlipState { detached = 0, stick = 1, partial_slip = 2, full_slip = 3 };

/// State of a contact by its area and the share that sticks.
/// @param area of the contact [m2]
/// @param stick_share of it, 0 to 1
SlipState slip_state(double area, double stick_share);

/// Onset of a slide. A contact under Coulomb friction slips at its rim while it is pressed already,
/// and what slipped may stick again when the slide begins: the first micro-slip is therefore taken
/// from the largest stuck share since the slide began.
struct SlipOnset {
  double begin = 0;      ///< of the slide in contact [s]
  double micro_slip = 0; ///< the stuck share has fallen by `micro_slip_share` [s]
  /// It is below `full_slip_share` [s]; none where the slide ends before.
  std::optional<double> full_slip;
  /// Lengths of the steps in which both were passed [s]; 0 without the second.
  double micro_slip_step = 0, full_slip_step = 0;
};

/// The onset of one slide; nothing where no such share ever sticks, or none slips. Linear between
/// the instants.
/// @param time [s], ascending
/// @param area, stick_share of the contact at these instants, see above
/// @param slide begin and end of the slide [s]
std::optional<SlipOnset> find_slip_onset(const std::vector<double>& time,
                                         const std::vector<double>& area,
                                         const std::vector<double>& stick_share,
                                         const std::array<double, 2>& slide);

} // namespace ionskin::readout
