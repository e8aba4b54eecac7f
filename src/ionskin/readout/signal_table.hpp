// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/signals.hpp"

#include <string>
#include <vector>

namespace ionskin::readout {

/// Motion and forces of one slider, one entry per row; empty in runs from a strain file, whose
/// columns then hold no values.
struct SliderInputs {
  std::vector<double> slider_x;         ///< centre [m]
  std::vector<double> slider_y;         ///< centre [m]
  std::vector<double> slider_z;         ///< underside above the undeformed top face [m]
  std::vector<double> normal_force;     ///< of the full skin [N]
  std::vector<double> tangential_force; ///< of the full skin, along the first slide [N]
  std::vector<double> tangential_force_x, tangential_force_y; ///< of the full skin [N]
  std::vector<double> moment_x, moment_y,
      moment_z;                     ///< on the skin, about the slider's centre [N m]
  std::vector<double> contact_area; ///< of the full skin [m2]
  std::vector<double> stick_share;  ///< of that area, where nothing slips, 0 to 1
  std::vector<double> slip;         ///< mean over the contact since it began [m]
  std::vector<double> slip_state;   ///< numbers of SlipState
};

/// Everything signals.csv is made of, one entry per row. The members of the base are those of the
/// first slider.
struct SignalInputs : SliderInputs {
  std::vector<double> time;               ///< [s], strictly ascending
  std::vector<int> cycle;                 ///< from 1
  std::vector<std::string> phase;         ///< touchdown, slide, lift, return
  std::vector<double> mean_shear;         ///< volume mean over the core [1]
  std::vector<double> rms_shear;          ///< [1]
  std::vector<double> p99_shear;          ///< percentile by volume [1]
  std::vector<double> shear_first_moment; ///< mean of gamma (zeta/h - 1/2) [1]
  std::vector<double> charge_top;         ///< on the metal [C]
  std::vector<double> charge_bottom;      ///< on the metal [C]
  // Columns of a slider on a drive; left empty, their columns are left out.
  std::vector<double> drive_x, drive_y;             ///< end of the drive [m]
  std::vector<double> drive_force_x, drive_force_y; ///< of the drive on the slider [N]
  /// Sliders beside the first, whose columns stand behind all others, each with `slider_suffix`.
  std::vector<SliderInputs> further_sliders;
};

/// Fills cycle, phase, slider_x and slider_y at the rows of `inputs.time` from the prescribed
/// motion.
void add_motion(SignalInputs& inputs, const Motion& motion, const Slider& slider);

/// The columns of signals.csv in their order, with rates and currents as means over the step that
/// ends at each row.
/// Throws InternalError when a given column has another length than `time`.
SignalTable build_signal_table(const SignalInputs& inputs);

} // namespace ionskin::readout
