// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/check_strain.hpp"

#include "command_line/threads.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/study/stations/given_strain.hpp"

#include <fmt/format.h>

namespace ionskin::apps {
namespace {

/// Empty where the ions have a sane solution.
std::string warning_of_strain(const Case& input, const history::CoreHistory& history) {
  try {
    electrochemistry::check_net_charge(input, history);
  } catch (const SolverError& error) {
    return fmt::format("warning: {}\n  in the strain file {}\n  = {}\n", error.what(),
                       input.strain.file, error.remedy());
  }
  return "";
}

} // namespace

int check_with_strain_file(const CheckOptions& options) {
  const CaseDocument document = read_case_document(options.case_path, options.set_edits);
  const history::CoreHistory history = study::read_given_strain(document.input).history;
  print_valid(options, document, warning_of_strain(document.input, history),
              planning::estimate_cost(document.input, history, thread_count(0)));
  return 0;
}

} // namespace ionskin::apps
