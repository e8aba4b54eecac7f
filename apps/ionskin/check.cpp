// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include "explain.hpp"

#include "ionskin/case/read_case.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <fmt/format.h>

namespace ionskin::apps {

int check(const CheckOptions& options) {
  const CaseDocument document = read_case_document(options.case_path, options.set_edits);
  // The mesh has a say too: it refuses sliders that leave no room for an element at the skin's
  // edge.
  if (document.input.strain.kind == StrainSourceKind::contact)
    mesh::SkinMesh{document.input};
  const std::string explanation = options.explain ? explain(document) : std::string();
  fmt::print("{} is valid.\n{}{}", options.case_path, warning_of_ions(document.input), explanation);
  return 0;
}

} // namespace ionskin::apps
