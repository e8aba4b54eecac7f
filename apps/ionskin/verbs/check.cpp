// SPDX-License-Identifier: Apache-2.0
#include "verbs/check.hpp"

#include "command_line/threads.hpp"
#include "terminal/terminal.hpp"
#include "verbs/check_json.hpp"
#include "verbs/explain.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/planning/foreseen.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/planning/resources.hpp"

#include <fmt/format.h>

namespace ionskin::apps {

namespace {

/// True if only a solution can tell whether the contact stays on the skin: the bound
/// `mesh::largest_footprint` reaches the edge, or does not hold because the slider adheres.
bool may_leave_skin(const Case& input) {
  const mesh::Footprint bound = mesh::largest_footprint(input);
  return laws::friction(input.contact.law, input.contact.friction, input.contact.parameters)
             .adhesion.pulls() ||
         mesh::ends_at_skin(input, bound, 0) || mesh::ends_at_skin(input, bound, 1);
}

std::string foreseen_warnings(const Case& input, const std::optional<mesh::Footprint>& found) {
  std::string text;
  for (const std::string& warning : planning::foreseen(input, found))
    text += "warning: " + warning + "\n";
  return text;
}

} // namespace

bool check(const CheckOptions& options) {
  const CaseDocument document = read_case_document(options.case_path, options.set_edits);
  const StrainSourceKind source = document.input.strain.kind;
  const bool round = source == StrainSourceKind::contact && !document.input.slider.sharp();
  if (source == StrainSourceKind::file ||
      (round && (options.explain || may_leave_skin(document.input)))) {
    return false;
  }
  check_case(options, document, std::nullopt);
  return true;
}

void check_case(const CheckOptions& options, const CaseDocument& document,
                const std::optional<mesh::Footprint>& footprint) {
  const bool contact = document.input.strain.kind == StrainSourceKind::contact;
  const int threads = thread_count(0);
  if (contact) {
    // The mesh has a say too: it refuses sliders that leave no room for an element at the skin's
    // edge. Under a round slider that never touches it would ask for elements without size.
    for (const Case& slider : cases_of_sliders(document.input)) {
      mechanics::require_touch(slider);
      mesh::SkinMesh{slider};
    }
  }
  const std::string shortage = planning::shortage(document.input, threads, footprint);
  print_valid(options, document,
              (contact ? foreseen_warnings(document.input, footprint) : "") +
                  warnings_of_water(document.input) +
                  (shortage.empty() ? "" : fmt::format("warning: {}\n", shortage)),
              planning::estimate_cost(document.input, threads, footprint));
}

void print_valid(const CheckOptions& options, const CaseDocument& document,
                 const std::string& warning, const planning::CostEstimate& cost) {
  if (options.json) {
    fmt::print("{}\n", check_json(document, warning, cost));
    return;
  }
  const std::string explanation = options.explain ? explain(document, cost) : std::string();
  std::string notes;
  for (const std::string& note : document.input.notes) {
    notes += paragraph("note: " + note, 2);
  }
  for (const std::string& note : {planning::announced_output(document.input, cost.output),
                                  planning::announced_time(document.input, cost)}) {
    notes += note.empty() ? "" : paragraph("note: " + note, 2);
  }
  fmt::print("{} is valid.\n{}{}{}", base::shown(options.case_path), notes, warning, explanation);
}

} // namespace ionskin::apps
