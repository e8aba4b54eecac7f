// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/check_solved.hpp"

#include "command_line/threads.hpp"
#include "terminal/progress_display.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/study/store/given_strain.hpp"

#include <fmt/format.h>

#include <optional>

#include <unistd.h>

namespace ionskin::apps {
namespace {

/// Warning on a strain history whose net charge the ion transport cannot hold; empty for none.
std::string warning_of_strain(const Case& input, const history::CoreHistory& history) {
  try {
    electrochemistry::check_net_charge(input, history);
  } catch (const SolverError& error) {
    return fmt::format("warning: {}\n  in the strain file {}\n  = {}\n", error.what(),
                       input.strain.file, error.remedy());
  }
  return "";
}

/// Finds the footprint of a slider without sharp edges as a run does, by a coarse solution; nullopt
/// where this fails, which a run will report. Throws UserError when the contact reaches the edge of
/// the skin.
std::optional<mesh::Footprint> found_footprint(const Case& input) {
  ProgressDisplay display(isatty(STDERR_FILENO) != 0 ? LogFormat::bar : LogFormat::none);
  try {
    return mechanics::find_footprint(input, input.contact.friction, thread_count(0),
                                     display.callback())
        .footprint;
  } catch (const SolverError&) {
    return std::nullopt;
  }
}

} // namespace

int check_with_solver(const CheckOptions& options) {
  const CaseDocument document = read_case_document(options.case_path, options.set_edits);
  if (document.input.strain.kind != StrainSourceKind::file) {
    check_case(options, document, found_footprint(document.input));
    return 0;
  }
  const history::CoreHistory history = study::read_given_strain(document.input).history;
  print_valid(options, document, warning_of_strain(document.input, history),
              planning::estimate_cost(document.input, history, thread_count(0)));
  return 0;
}

} // namespace ionskin::apps
