// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/write_outputs.hpp"

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/results/csv_writer.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/results_file.hpp"
#include "ionskin/results/summary_json.hpp"
#include "ionskin/results/vtu_writer.hpp"
#include "ionskin/study/run/report.hpp"
#include "ionskin/study/store/skin_snapshots.hpp"

#include <algorithm>

namespace ionskin::study {
namespace {

namespace names = results::file_names;

/// Writes a table that only some readouts have, and removes that of an earlier run.
void write_optional(results::ResultsFile& file, const std::string& group,
                    const std::optional<readout::SignalTable>& table) {
  file.file().remove("/" + group);
  if (table) {
    file.write_signals(group, *table);
  }
}

void write_optional(RunFolder& folder, const char* name,
                    const std::optional<readout::SignalTable>& table) {
  folder.output().remove(name);
  if (table) {
    results::write_csv(folder.own(name), *table);
  }
}

/// The table, or nothing where it has no columns, as in a run without an error estimate.
std::optional<readout::SignalTable> present(const readout::SignalTable& table) {
  return table.columns.empty() ? std::nullopt : std::optional(table);
}

void write_results_file(const Case& input, const MechanicsRecord& mechanics,
                        const RunOutputs& outputs, RunFolder& folder) {
  using Start = results::ResultsFile::Start;
  results::ResultsFile file(folder.own(names::results),
                            mechanics.has_contact() ? Start::extend : Start::empty);
  file.write_signals("signals", outputs.signals.resolved);
  file.write_signals("sampled", outputs.signals.sampled);
  write_optional(file, "taxels", outputs.signals.taxels);
  write_optional(file, "circuit", outputs.signals.circuit);
  write_optional(file, "water", outputs.signals.water);
  write_optional(file, "sampled_taxels", outputs.signals.sampled_taxels);
  write_optional(file, "sampled_circuit", outputs.signals.sampled_circuit);
  write_optional(file, "signals_error", present(outputs.errors.signals));
  write_optional(file, "sampled_error", present(outputs.errors.sampled));
  write_optional(file, "taxels_error", outputs.errors.taxels);
  write_optional(file, "circuit_error", outputs.errors.circuit);
  write_optional(file, "water_error", outputs.errors.water);
  if (mechanics.has_contact()) {
    file.write_slider(input.slider);
    for (std::size_t i = 0; i < input.further_sliders.size(); ++i) {
      file.write_slider(input.further_sliders[i].slider, readout::slider_suffix(i + 1));
    }
  } else {
    file.write_strain(mechanics.history);
  }
  if (outputs.ions) {
    file.write_ions(outputs.ions->grid, outputs.ions->snapshots);
  }
  file.write_text("case", input.text);
  file.write_text("manifest", results::manifest_text(folder.manifest()));
  file.commit();
}

void set_counters(const MechanicsRecord& mechanics, const RunOutputs& outputs, RunFolder& folder) {
  if (mechanics.has_contact()) {
    folder.set_counter("contact_solves", mechanics.contact_solves);
  }
  if (outputs.ions) {
    folder.set_counter("time_steps", static_cast<double>(outputs.ions->steps));
    folder.set_counter("rejected_steps", static_cast<double>(outputs.ions->rejected_steps));
    folder.set_counter("residual_evaluations",
                       static_cast<double>(outputs.ions->residual_evaluations));
    folder.set_counter("krylov_iterations", static_cast<double>(outputs.ions->krylov_iterations));
    folder.set_counter("preconditioner_setups",
                       static_cast<double>(outputs.ions->preconditioner_setups));
  }
  for (const auto& [stage, seconds] : outputs.stage_seconds) {
    folder.set_counter("seconds_" + stage, seconds);
  }
}

/// Wall time per stage [s], from the manifest, so that a resumed run counts the time of the
/// interrupted one.
std::map<std::string, double> timing(const RunFolder& folder, double start) {
  std::map<std::string, double> result;
  for (const char* stage : {"mechanics", "strain", "electrochemistry", "output"}) {
    const auto found = folder.manifest().stages.find(stage);
    result[stage] = found == folder.manifest().stages.end() ? 0.0 : found->second.wall_time;
  }
  result["total"] = base::wall_time() - start;
  return result;
}

results::Summary summary_of(const Case& input, const RunOutputs& outputs) {
  results::Summary summary;
  summary.metrics = outputs.signals.metrics;
  summary.warnings = outputs.warnings;
  for (const Audit& one : outputs.audits) {
    summary.audits.push_back(
        {one.rule->metric, one.value, one.rule->warn, one.rule->fail, to_string(one.verdict)});
  }
  summary.error_estimate = outputs.errors.relative;
  summary.error_parts = outputs.errors.parts;
  summary.not_converging = outputs.errors.not_converging;
  summary.not_estimated = outputs.errors.not_estimated;
  if (outputs.ions) {
    const circuits::Circuit circuit =
        circuits::circuit(input.readout.circuit, input.readout.parameters);
    summary.circuit = results::CircuitEntry{std::string(circuit.name), circuit.words,
                                            std::string(circuits::top_potential(circuit))};
    if (input.readout.is_cut()) {
      const bool crossbar = input.readout.is_crossbar();
      summary.circuit->words = crossbar ? "columns and rows of a crossbar, each with a circuit"
                                        : "taxels with circuits of their own";
      summary.circuit->top_potential =
          crossbar ? "φ = U of each column and row" : "φ = U of each taxel";
    }
  }
  return summary;
}

/// Writes the ion fields that Study 2 stored, and the ParaView file that opens them together with
/// the files of Study 1.
void write_paraview(const Case& input, const RunOutputs& outputs, RunFolder& folder) {
  if (outputs.ions) {
    results::write_fields(folder.output(), outputs.ions->grid, input.skin.core_bottom(),
                          outputs.ions->snapshots);
  }
  std::vector<std::string> suffixes;
  for (std::size_t i = 0; i <= input.further_sliders.size(); ++i) {
    suffixes.push_back(readout::slider_suffix(i));
  }
  results::write_collection(folder.output(), field_instants(input), suffixes);
}

constexpr const char* writing = "results and report";

std::optional<std::string> draw_report(const RunOptions& options, RunFolder& folder) {
  if (!options.report) {
    return std::nullopt;
  }
  return make_report(folder.path(), options.figures,
                     [&](double part) { options.progress(writing, 0.5 * (1 + part)); });
}

} // namespace

RunOutcome complete_report(const RunOptions& options, double start, RunFolder& folder) {
  const bool missing = options.report && !std::filesystem::exists(folder.file(names::report));
  const auto problem = missing ? draw_report(options, folder) : std::nullopt;
  results::Summary summary = results::read_summary(folder.file(names::summary));
  if (problem) {
    summary.warnings.push_back(*problem);
  }
  const bool reported = std::filesystem::exists(folder.file(names::report));
  ErrorEstimate errors;
  errors.relative = summary.error_estimate;
  errors.parts = summary.error_parts;
  errors.not_converging = summary.not_converging;
  errors.not_estimated = summary.not_estimated;
  return {.folder = folder.path(),
          .report = reported ? folder.file(names::report) : std::filesystem::path{},
          .report_problem = problem.value_or(""),
          .metrics = summary.metrics,
          .errors = std::move(errors),
          .warnings = summary.warnings,
          .seconds = base::wall_time() - start};
}

void write_unfinished(const Case& input, const RunOutputs& outputs, double start,
                      RunFolder& folder) {
  results::Summary summary = summary_of(input, outputs);
  summary.timing = timing(folder, start);
  write_optional(folder, names::signals, present(outputs.signals.resolved));
  write_optional(folder, names::sampled, present(outputs.signals.sampled));
  results::write_summary(folder.own(names::summary), summary);
}

RunOutcome write_outputs(const Case& input, const RunOptions& options,
                         const MechanicsRecord& mechanics, const RunOutputs& outputs, double start,
                         RunFolder& folder) {
  set_counters(mechanics, outputs, folder);
  results::Summary summary = summary_of(input, outputs);
  const auto write_summary = [&] {
    summary.timing = timing(folder, start);
    results::write_summary(folder.own(names::summary), summary);
  };
  const auto report_problem = folder.stage("output", [&] {
    options.progress(writing, 0.0);
    results::write_csv(folder.own(names::signals), outputs.signals.resolved);
    results::write_csv(folder.own(names::sampled), outputs.signals.sampled);
    write_optional(folder, names::taxels, outputs.signals.taxels);
    write_optional(folder, names::circuit, outputs.signals.circuit);
    write_optional(folder, names::water, outputs.signals.water);
    write_optional(folder, names::sampled_taxels, outputs.signals.sampled_taxels);
    write_optional(folder, names::sampled_circuit, outputs.signals.sampled_circuit);
    write_optional(folder, names::signals_error, present(outputs.errors.signals));
    write_optional(folder, names::sampled_error, present(outputs.errors.sampled));
    write_optional(folder, names::taxels_error, outputs.errors.taxels);
    write_optional(folder, names::circuit_error, outputs.errors.circuit);
    write_optional(folder, names::water_error, outputs.errors.water);
    if (options.paraview) {
      write_paraview(input, outputs, folder);
    }
    write_results_file(input, mechanics, outputs, folder);
    // The report reads the summary, so it is written first; the report's own time is added below.
    write_summary();
    options.progress(writing, 0.5);
    auto problem = draw_report(options, folder);
    options.progress(writing, 1.0);
    return problem;
  });
  if (report_problem) {
    summary.warnings.push_back(*report_problem);
  }
  write_summary();
  const bool sound = std::ranges::none_of(
      outputs.audits, [](const Audit& one) { return one.verdict == Verdict::failed; });
  folder.finish(sound);
  const bool reported = options.report && !report_problem;
  return {.folder = folder.path(),
          .report = reported ? folder.file(names::report) : std::filesystem::path{},
          .report_problem = report_problem.value_or(""),
          .metrics = summary.metrics,
          .errors = outputs.errors,
          .warnings = summary.warnings,
          .seconds = base::wall_time() - start};
}

} // namespace ionskin::study
