// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/unfinished.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/study/errors/error_estimate.hpp"
#include "ionskin/study/metrics/audits.hpp"
#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/run/warnings.hpp"
#include "ionskin/study/run/write_outputs.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace ionskin::study {
namespace {

std::string shortfall_warning(const std::string& what_is_kept, const SolverError& error) {
  return fmt::format("The run is unfinished: {}. Why: {}. What helps: {}.", what_is_kept,
                     error.what(), error.remedy());
}

void write(const Case& input, RunOutputs& outputs, double start, RunFolder& folder) {
  outputs.errors = no_estimate(outputs.signals, "the run is unfinished");
  try {
    write_unfinished(input, outputs, start, folder);
  } catch (const base::UnwritableFile&) { // the error of the solver matters more
  }
}

/// Signals of the first cycle, up to the end of the path that was solved.
Signals signals_of(const Case& input, const RunOptions& options,
                   const mechanics::ContactSolution& path) {
  Case once = input;
  once.motion.cycles = 1;
  return read_out_mechanics_rows(once, make_mechanics_record(once, path), options.threads);
}

} // namespace

void keep_unfinished_contact(const Case& input, const RunOptions& options,
                             const std::optional<mechanics::ContactSolution>& path,
                             const SolverError& error, double start, RunFolder& folder) {
  RunOutputs outputs;
  std::string kept = input.further_sliders.empty()
                         ? "no step of the contact was solved"
                         : "of several sliders, which are solved in passes, no path is kept";
  if (path && path->stepped.size() > 1) {
    try {
      outputs.signals = signals_of(input, options, *path);
      kept = fmt::format("its signals end at {:.6g} s, where the contact gave up, and it has no "
                         "figures",
                         path->stepped.back().time);
    } catch (const SolverError&) { // the strain is not a number
      kept = "the contact gave up, and its strain is not a number";
    }
  }
  outputs.warnings.push_back(shortfall_warning(kept, error));
  write(input, outputs, start, folder);
}

void keep_unfinished_ions(const Case& input, const RunOptions& options,
                          const MechanicsRecord& mechanics,
                          const electrochemistry::IonSolution* ions, const SolverError& error,
                          double start, RunFolder& folder) {
  RunOutputs outputs;
  outputs.signals = read_out_mechanics(input, mechanics, options.threads);
  outputs.audits = audit(audited_metrics(mechanics, outputs.signals));
  outputs.warnings = mechanics_warnings(input, mechanics);
  outputs.warnings.push_back(shortfall_warning(
      fmt::format("{}its figures are those of the strain alone",
                  ions != nullptr ? "its signals end where the ion transport gave up, and " : ""),
      error));
  if (ions != nullptr) {
    Signals rows = read_out_rows(input, mechanics, *ions, options.threads);
    outputs.signals.resolved = std::move(rows.resolved);
    outputs.signals.sampled = std::move(rows.sampled);
  }
  write(input, outputs, start, folder);
}

} // namespace ionskin::study
