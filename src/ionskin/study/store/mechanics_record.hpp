// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/results/contact_map.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ionskin::study {

/// Record of the contact of one slider, one entry per sample of the history; empty in runs from a
/// strain file.
struct SliderRecord {
  std::vector<double> slider_z;         ///< underside above the undeformed top face [m]
  std::vector<double> normal_force;     ///< [N]
  std::vector<double> tangential_force; ///< along the first slide [N]
  std::vector<double> tangential_force_x, tangential_force_y; ///< [N]
  std::vector<double> moment_x, moment_y, moment_z;           ///< about the slider's centre [N m]
  std::vector<double> contact_area;                           ///< [m2]
  std::vector<double> stick_share;                            ///< of that area, 0 to 1
  std::vector<double> slip; ///< mean over the contact since it began [m]
  /// Force of a drive on the slider; empty without one.
  std::vector<double> drive_force_x, drive_force_y; ///< [N]
  double join_time = 0; ///< from which all slips its way in the first slide [s]
  /// Begin of each slide of a cycle, and from when all of the contact slips its way [s].
  std::vector<std::array<double, 2>> onsets;
  results::ContactMaps maps; ///< half models hold y <= 0 only
  double worst_equilibrium_residual = 0;
  double worst_complementarity_residual = 0;
  int contact_solves = 0;
  std::vector<readout::Metric> metrics; ///< of the contact, for summary.json
  /// Errors by the name of a metric: error that cells of the contact leave in it, however little
  /// two meshes differ by.
  std::vector<readout::Metric> cell_errors;
  /// Largest membrane stress of each electrode layer over all states, bottom to top, by the forces
  /// of this slider alone [Pa].
  std::vector<double> electrode_stress;
  std::vector<std::string> warnings;
};

/// Record that Study 1 leaves to everything after it. It is written when Study 1 ends and read back
/// by a resumed run, so that Study 1 never runs twice. The members of the base are those of the
/// first slider.
struct MechanicsRecord : SliderRecord {
  history::CoreHistory history;
  std::vector<SliderRecord> further_sliders; ///< of a case with several
  /// Mechanics on coarser meshes, without maps, by name (mechanics/coarser_solutions.hpp): they
  /// give the errors. Empty where those have no solution, and with a given strain.
  std::map<std::string, std::shared_ptr<const MechanicsRecord>> coarser_solutions;

  bool has_contact() const { return !normal_force.empty(); }
};

/// Condenses the contact states into forces, maps and the shear history of the whole run.
/// @param progress called with "strain history"
/// @param contacts one solution for each slider of the case
MechanicsRecord make_mechanics_record(const Case& input,
                                      const std::vector<mechanics::ContactSolution>& contacts,
                                      const base::ProgressCallback& progress = base::no_progress);

/// Record of a case of one slider.
MechanicsRecord make_mechanics_record(const Case& input, const mechanics::ContactSolution& contact,
                                      const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::study
