// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace ionskin::readout {

/// Share of the contact area that may slip while the contact still counts as sticking; also the
/// drop of the sticking share that marks the first micro-slip. Below this share, single cells of
/// the mesh decide.
inline constexpr double micro_slip_share = 0.05;
/// Sticking share of the contact area at or below which the contact counts as fully slipping.
inline constexpr double full_slip_share = 0.01;

/// State of the contact; the numbers are those of the column `slip_state` of signals.csv.
enum class SlipState { detached = 0, stick = 1, partial_slip = 2, full_slip = 3 };

/// Classifies a contact by its area and the share of it that sticks.
/// @param area of the contact [m2]
/// @param stick_share sticking share of the area, 0 to 1
SlipState slip_state(double area, double stick_share);

/// Onset of slip in one slide. A contact with Coulomb friction slips at its rim already while it is
/// pressed, and what slipped may stick again when the slide begins. The first micro-slip is
/// therefore defined by the drop from the largest sticking share since the slide began.
struct SlipOnset {
  /// First instant of the slide in contact [s].
  double begin = 0;
  /// Instant at which the sticking share has fallen by `micro_slip_share` [s].
  double micro_slip = 0;
  /// Instant at which the sticking share reaches `full_slip_share` [s]; empty if the slide ends
  /// before.
  std::optional<double> full_slip;
  /// Lengths of the time steps in which these two instants lie [s]; the second is 0 without full
  /// slip.
  double micro_slip_step = 0, full_slip_step = 0;
};

/// Finds the onset of slip in one slide, with the sticking share linear between the instants.
/// Returns nothing where too little of the contact ever sticks, or no micro-slip occurs.
/// @param time of the instants [s], ascending
/// @param area of the contact [instant] [m2]
/// @param stick_share sticking share of the area, 0 to 1 [instant]
/// @param slide begin and end of the slide [s]
std::optional<SlipOnset> find_slip_onset(const std::vector<double>& time,
                                         const std::vector<double>& area,
                                         const std::vector<double>& stick_share,
                                         const std::array<double, 2>& slide);

} // namespace ionskin::readout
