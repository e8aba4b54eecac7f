// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/run_case.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/case/checks/check_sizes.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/planning/foreseen.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/vtu_writer.hpp"
#include "ionskin/study/errors/error_estimate.hpp"
#include "ionskin/study/metrics/audits.hpp"
#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/run/solve_mechanics.hpp"
#include "ionskin/study/run/unfinished.hpp"
#include "ionskin/study/run/warnings.hpp"
#include "ionskin/study/run/write_outputs.hpp"
#include "ionskin/study/store/checkpoint_file.hpp"
#include "ionskin/study/store/given_strain.hpp"
#include "ionskin/study/store/mechanics_file.hpp"
#include "ionskin/study/store/mechanics_record.hpp"
#include "ionskin/study/store/mechanics_store.hpp"
#include "ionskin/study/store/skin_snapshots.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace ionskin::study {
namespace {

using electrochemistry::IonSolution;

std::optional<GivenStrain> strain_without_contact(const Case& input, const RunOptions& options) {
  if (input.strain.kind == StrainSourceKind::contact) {
    return std::nullopt;
  }
  if (options.studies == Studies::mechanics) {
    throw UserError(
        fmt::format("--only mechanics has nothing to do: strain.source = \"{}\" gives the strain\n"
                    "  = leave out --only, or set strain.source = \"contact\"",
                    input.strain.kind == StrainSourceKind::file ? "file" : "prescribed"));
  }
  if (input.strain.kind == StrainSourceKind::prescribed) {
    return GivenStrain{poroelasticity::prescribed_history(input), {}};
  }
  return read_given_strain(input);
}

MechanicsRecord record_of(GivenStrain given) {
  MechanicsRecord record;
  record.history = std::move(given.history);
  return record;
}

/// Reads the record of Study 1 that an earlier run left in its folder; empty where there is none.
/// @param path of its results.h5
std::optional<MechanicsRecord> left_mechanics(const Case& input, const std::string& hash,
                                              const std::filesystem::path& path,
                                              RunFolder& folder) {
  MechanicsStore store;
  store.add(hash, path);
  auto record = store.read(hash, input.skin);
  for (const std::string& note : store.notes()) {
    folder.note(note);
  }
  return record;
}

/// Writes skin and slider at the instants of `output.fields` for ParaView, while the strains of the
/// contact can still be recovered.
void write_skins(const Case& input, const std::vector<mechanics::ContactSolution>& contacts,
                 RunFolder& folder) {
  const std::vector<double> instants = field_instants(input);
  if (instants.empty()) {
    return;
  }
  const std::vector<Case> sliders = cases_of_sliders(input);
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const mechanics::LayerStrainAt strain = layer_strains(contacts[i]);
    for (std::size_t at = 0; at < instants.size(); ++at) {
      results::write_skin(folder.output(), sliders[i].slider, readout::slider_suffix(i), at,
                          skin_snapshot(sliders[i], contacts[i], strain, instants[at]));
    }
  }
}

/// Case -> ContactSolution -> CoreHistory: solves Study 1, or reads what an earlier run left of it
/// in its folder.
MechanicsRecord study_1(const Case& input, const RunOptions& options, double start,
                        RunFolder& folder, base::Timers& timers) {
  const auto results_path = folder.own(results::file_names::results);
  const std::string hash = mechanics_hash(input);
  if (auto record = left_mechanics(input, hash, results_path, folder)) {
    folder.keep_finished("strain");
    options.progress("mechanics, from an earlier run", 1.0);
    return *record;
  }
  if (options.studies == Studies::electrochemistry) {
    throw UserError(folder.path().string() +
                    " holds no finished mechanics of this case, which --only electrochemistry "
                    "needs: run without --only, or with "
                    "--only mechanics, first");
  }
  std::optional<mechanics::ContactSolution> path; // up to where the contact gave up
  const auto solve = [&] {
    mechanics::ContactOptions contact_options;
    contact_options.threads = options.threads;
    contact_options.progress = options.progress;
    contact_options.unfinished = [&](const mechanics::ContactSolution& some) { path = some; };
    return std::move(
        solve_mechanics(input, {input.contact.friction}, contact_options, timers).front());
  };
  const auto solved = [&] {
    try {
      return folder.stage("mechanics", solve);
    } catch (const SolverError& error) {
      keep_unfinished_contact(input, options, path, error, start, folder);
      throw;
    }
  }();
  return folder.stage("strain", [&] {
    options.progress("strain history", 0.0);
    constexpr double share_of_files = 0.25;
    MechanicsRecord record =
        record_mechanics(input, solved, base::share_of(options.progress, 0, 1 - share_of_files));
    if (options.paraview) {
      write_skins(input, solved.contacts, folder);
    }
    write_mechanics(results_path, hash, record,
                    base::share_of(options.progress, 1 - share_of_files, share_of_files));
    options.progress("strain history", 1.0);
    return record;
  });
}

/// Hash of everything that decides Study 2. It includes the strain history: results computed from
/// another history, as of a Study 1 that was solved again, cannot be reused.
std::string transport_hash(const std::string& input_hash, const history::CoreHistory& history) {
  base::DigestBuilder builder;
  builder.add(std::string_view(input_hash)).add(history.time).add(history.slider_x);
  for (const history::HistoryChannel& channel : history.channels) {
    builder.add(std::string_view(channel.name));
    const history::StrainField* last = nullptr;
    for (const auto& field : channel.samples) {
      builder.add(field.get() == last);
      if (field.get() != last) {
        builder.add(*field);
      }
      last = field.get();
    }
  }
  return builder.finish().hex();
}

/// CoreHistory -> IonSolution: solves Study 2 from the start or from a checkpoint. The last
/// checkpoint is the end of Study 2, and is stored until the whole run is finished.
IonSolution study_2(const Case& input, const RunOptions& options, RunFolder& folder,
                    const history::CoreHistory& history, base::Timers& timers) {
  const auto checkpoint_path = folder.own(results::file_names::checkpoint);
  const std::string hash = transport_hash(folder.manifest().input_hash, history);
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  ion_options.snapshot_times = input.output.fields;
  ion_options.checkpoint = [&](const electrochemistry::IonCheckpoint& checkpoint) {
    write_checkpoint(checkpoint_path, hash, checkpoint);
  };
  if (options.resume && folder.holds(results::file_names::checkpoint)) {
    ion_options.resume = read_checkpoint(checkpoint_path, hash);
  }
  return folder.stage("electrochemistry", [&] {
    electrochemistry::check_fixed_charge(input, history);
    electrochemistry::check_net_charge(input, history);
    return electrochemistry::solve_ion_transport(input, history, ion_options, timers);
  });
}

/// Adds the error estimate to the results of a run. If the errors cannot be estimated, the run
/// keeps its results and warns.
void add_errors(const Case& input, const MechanicsRecord& mechanics, const RunOptions& options,
                base::Timers& timers, RunOutputs& outputs) {
  if (!input.numerics.error_estimate) {
    outputs.errors = no_estimate(outputs.signals, "numerics.error_estimate is off");
    return;
  }
  options.progress("error estimate", 0.0);
  try {
    outputs.errors =
        outputs.ions
            ? estimate_errors(input, mechanics, *outputs.ions, outputs.signals, options.threads,
                              timers, options.progress)
            : estimate_mechanics_errors(input, mechanics, outputs.signals, options.threads);
    std::vector<std::string> found = error_warnings(input, outputs.errors);
    outputs.warnings.insert(outputs.warnings.begin(), found.begin(), found.end());
  } catch (const SolverError& error) {
    outputs.warnings.push_back(
        std::string("The error of the currents is not estimated: on a mesh of twice the size ") +
        error.what() + ".");
    outputs.errors = estimate_mechanics_errors(input, mechanics, outputs.signals, options.threads);
  }
  options.progress("error estimate", 1.0);
}

/// True if an earlier run has finished these studies, except perhaps for the report.
bool has_finished(const RunFolder& folder, const RunOptions& options) {
  return options.resume && folder.is_complete() &&
         (options.studies == Studies::mechanics || folder.was_finished("electrochemistry"));
}

/// Size of the files that the folder holds already, which are reused or replaced [bytes].
double bytes_in(const std::filesystem::path& folder) {
  double sum = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (std::filesystem::is_regular_file(entry.symlink_status(error))) {
      sum += static_cast<double>(entry.file_size(error));
    }
  }
  return sum;
}

/// Checks, before any work, that the results have room on the disk. For the points of a sweep, the
/// sweep checks all together, except for points with a strain file: only the file tells how long
/// they last.
void require_room(const Case& input, const std::optional<GivenStrain>& given,
                  const RunOptions& options) {
  const bool from_file = input.strain.kind == StrainSourceKind::file;
  if (from_file || options.judge_resources) {
    const double bytes =
        from_file ? planning::estimate_cost(input, given->history, options.threads).output
                  : planning::expected_output(input, options.studies != Studies::mechanics);
    planning::require_disk(bytes - bytes_in(options.folder), options.folder);
  }
}

} // namespace

RunOutcome run_case(const Case& input, const RunOptions& options) {
  const double start = base::wall_time();
  auto given_strain = strain_without_contact(input, options);
  if (options.judge_resources) {
    planning::require_resources(input, options.threads);
  }
  require_room(input, given_strain, options);
  if (options.studies != Studies::mechanics) {
    planning::foreseen(input); // throws UserError if the run is bound to fail
  }
  RunFolder folder(input, options);
  if (has_finished(folder, options)) {
    return complete_report(options, start, folder);
  }
  base::Timers timers;
  if (input.strain.kind == StrainSourceKind::file) {
    require_unchanged(input, *given_strain);
  }

  const MechanicsRecord mechanics = given_strain ? record_of(std::move(*given_strain))
                                                 : study_1(input, options, start, folder, timers);
  RunOutputs outputs;
  if (options.studies == Studies::mechanics) {
    outputs.signals = read_out_mechanics(input, mechanics, options.threads);
    outputs.warnings = mechanics_warnings(input, mechanics);
  } else {
    try {
      outputs.ions = study_2(input, options, folder, mechanics.history, timers);
    } catch (const SolverError& error) {
      const auto checkpoint =
          read_checkpoint(folder.file(results::file_names::checkpoint),
                          transport_hash(folder.manifest().input_hash, mechanics.history));
      keep_unfinished_ions(input, options, mechanics, checkpoint ? &checkpoint->solution : nullptr,
                           error, start, folder);
      throw;
    }
    outputs.signals = read_out(input, mechanics, *outputs.ions, options.threads);
    outputs.warnings = collect_warnings(input, mechanics, *outputs.ions, outputs.signals.resolved);
    outputs.warnings.insert(outputs.warnings.end(), outputs.signals.warnings.begin(),
                            outputs.signals.warnings.end());
  }
  outputs.warnings.insert(outputs.warnings.end(), folder.notes().begin(), folder.notes().end());
  add_errors(input, mechanics, options, timers, outputs);
  outputs.stage_seconds = timers.seconds();
  outputs.audits = audit(audited_metrics(mechanics, outputs.signals));
  const std::vector<std::string> audited = audit_warnings(outputs.audits);
  outputs.warnings.insert(outputs.warnings.begin(), audited.begin(), audited.end());
  RunOutcome outcome = write_outputs(input, options, mechanics, outputs, start, folder);
  folder.output().remove(results::file_names::checkpoint);
  require_sound(outputs.audits, folder.path().string());
  return outcome;
}

} // namespace ionskin::study
