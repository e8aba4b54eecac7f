// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/signals.hpp"

#include <string>
#include <vector>

namespace ionskin::readout {

/// Motion and forces of one slider for signals.csv, one entry per row. All vectors are empty in
/// runs from a strain file, where the columns hold NaN.
struct SliderInputs {
  std::vector<double> slider_x;     ///< of the slider's centre [m]
  std::vector<double> slider_y;     ///< of the slider's centre [m]
  std::vector<double> slider_z;     ///< height of the underside above the undeformed top face [m]
  std::vector<double> normal_force; ///< on the full skin [N]
  std::vector<double> tangential_force; ///< on the full skin, along the first slide [N]
  std::vector<double> tangential_force_x, tangential_force_y; ///< on the full skin [N]
  /// Moments of the forces on the skin about the slider's centre on the undeformed top face [N m].
  std::vector<double> moment_x, moment_y, moment_z;
  std::vector<double> contact_area; ///< full area, also if one symmetric half is modelled [m2]
  std::vector<double> stick_share;  ///< share of `contact_area` that sticks, 0 to 1 [1]
  std::vector<double> slip;         ///< mean slip over the contact since it began [m]
  std::vector<double> slip_state;   ///< number of the `SlipState` [1]
};

/// All quantities from which signals.csv is made, one entry per row. The inherited members are
/// those of the first slider.
struct SignalInputs : SliderInputs {
  std::vector<double> time;               ///< [s], strictly ascending
  std::vector<int> cycle;                 ///< from 1
  std::vector<std::string> phase;         ///< touchdown, slide, lift, return
  std::vector<double> mean_shear;         ///< mean over the core's volume [1]
  std::vector<double> rms_shear;          ///< root mean square over the core's volume [1]
  std::vector<double> p99_shear;          ///< 99th percentile over the core's volume [1]
  std::vector<double> shear_first_moment; ///< mean of gamma (zeta/h - 1/2) [1]
  std::vector<double> charge_top;         ///< on the metal [C]
  std::vector<double> charge_bottom;      ///< on the metal [C]
  // Columns of a slider on a drive (spring and damper between a prescribed path and the slider); if
  // empty, these columns are left out.
  std::vector<double> drive_x, drive_y; ///< position of the end that follows the path [m]
  std::vector<double> drive_force_x, drive_force_y; ///< force of the drive on the slider [N]
  /// Further sliders, from the second on. Their columns follow all others, with names that end in
  /// `slider_suffix`.
  std::vector<SliderInputs> further_sliders;
};

/// Appends cycle, phase, slider_x and slider_y at the rows of `inputs.time`, from the prescribed
/// motion.
void add_motion(SignalInputs& inputs, const Motion& motion, const Slider& slider);

/// Makes the table of signals.csv, with its columns in order; rates and currents are means over the
/// step that ends at each row. Throws InternalError when a column has another length than `time`.
SignalTable build_signal_table(const SignalInputs& inputs);

} // namespace ionskin::readout
