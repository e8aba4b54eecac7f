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

/// Contact of one slider over time, with one entry per sample of the strain history. Vectors are
/// empty in runs from a strain file or under a prescribed load.
struct SliderRecord {
  /// Height of the slider's underside above the undeformed top face [m].
  std::vector<double> slider_z;
  std::vector<double> normal_force; ///< force on the full skin, compression positive [N]
  /// Component along the direction of the first slide, on the skin [N].
  std::vector<double> tangential_force;
  /// Components along x and y, on the skin [N].
  std::vector<double> tangential_force_x, tangential_force_y;
  /// Moments of the forces on the skin about the slider's centre on the undeformed top face [N m].
  std::vector<double> moment_x, moment_y, moment_z;
  std::vector<double> contact_area; ///< [m2]
  std::vector<double> stick_share;  ///< sticking share of the contact area, 0 to 1
  std::vector<double> slip;         ///< length of slip since touchdown, mean over the contact [m]
  /// Force of the drive on the slider along x and y; empty without a drive.
  std::vector<double> drive_force_x, drive_force_y; ///< [N]
  double join_time = 0; ///< instant from which the whole contact slips in the first slide [s]
  /// For each slide of a cycle, its start and the instant from which the whole contact slips [s].
  std::vector<std::array<double, 2>> onsets;
  /// Maps of traction and slip over the contact cells; half models hold y <= 0 only.
  results::ContactMaps maps;
  /// Largest difference between the contact forces and the forces through the core, relative [1].
  double worst_equilibrium_residual = 0;
  /// Largest violation of the contact and friction conditions, relative [1].
  double worst_complementarity_residual = 0;
  /// Number of contact equilibria that were solved.
  int contact_solves = 0;
  /// True if the contact ends at a sharp edge of the slider, around which the skin bends.
  bool sharp_edge = false;
  std::vector<readout::Metric> metrics; ///< scalar results of the contact, for summary.json
  /// Least errors of some metrics, by the metric's name and in its unit, that the finite size of
  /// the contact cells leaves even where two meshes happen to agree.
  std::vector<readout::Metric> cell_errors;
  /// Largest von Mises membrane stress of each electrode layer over all states, bottom to top,
  /// caused by the forces of this slider only [Pa].
  std::vector<double> electrode_stress;
  std::vector<std::string> warnings;
};

/// Record of Study 1 (contact mechanics) for everything that follows. It is written when Study 1
/// ends and read by a resumed run, so that Study 1 is never solved twice. The base class holds the
/// first slider.
struct MechanicsRecord : SliderRecord {
  /// Strain history of the core, from which the ions are driven in Study 2.
  history::CoreHistory history;
  /// Sliders after the first, in a case with several; empty otherwise.
  std::vector<SliderRecord> further_sliders;
  /// Records of the coarser solutions, without maps, by name (mechanics/coarser_solutions.hpp);
  /// errors are estimated from them. Empty where they were not solved, have no solution, or the
  /// strain is given.
  std::map<std::string, std::shared_ptr<const MechanicsRecord>> coarser_solutions;

  /// True if a contact was solved, false if the strain was given.
  bool has_contact() const { return !normal_force.empty(); }
};

/// Reduces the contact solutions of a case to forces, maps and the strain history of the whole run.
/// @param contacts one solution for each slider of the case
/// @param progress receives the activity "strain history"
MechanicsRecord make_mechanics_record(const Case& input,
                                      const std::vector<mechanics::ContactSolution>& contacts,
                                      const base::ProgressCallback& progress = base::no_progress);

/// Reduces the contact solution of a case with one slider to its record.
/// @param progress receives the activity "strain history"
MechanicsRecord make_mechanics_record(const Case& input, const mechanics::ContactSolution& contact,
                                      const base::ProgressCallback& progress = base::no_progress);

} // namespace ionskin::study
