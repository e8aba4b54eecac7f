// SPDX-License-Identifier: Apache-2.0
#include "verbs/check.hpp"

#include "command_line/threads.hpp"
#include "terminal/terminal.hpp"
#include "verbs/check_json.hpp"
#include "verbs/explain.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/planning/foreseen.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/planning/resources.hpp"

#include <fmt/format.h>

namespace ionskin::apps {

namespace {

/// The contact is not solved for: `mesh::expected_footprint` tells it, as for the memory of a run.
std::string warning_of_edge(const Case& input, const std::optional<mesh::Footprint>& found) {
  const mesh::Footprint footprint = found ? *found : mesh::expected_footprint(input);
  std::string text;
  for (const std::size_t d : {0, 1})
    if (mesh::ends_at_skin(input, footprint, d))
      text +=
          paragraph(fmt::format("warning: the contact is expected to reach the edge of the skin "
                                "along {}, and a run would end there: {}",
                                d == 0 ? "x" : "y", mechanics::remedy_of_edge),
                    2);
  return text;
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
  if (source == StrainSourceKind::file || (round && options.explain)) {
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
    // edge.
    mesh::SkinMesh{document.input};
    mechanics::require_touch(document.input);
  }
  const std::string shortage = planning::shortage(document.input, threads, footprint);
  print_valid(options, document,
              (contact ? warning_of_edge(document.input, footprint) +
                             foreseen_warnings(document.input, footprint)
                       : "") +
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
  if (const std::string size = planning::announced_output(document.input, cost.output);
      !size.empty()) {
    notes += paragraph("note: " + size, 2);
  }
  fmt::print("{} is valid.\n{}{}{}", base::shown(options.case_path), notes, warning, explanation);
}

} // namespace ionskin::apps
