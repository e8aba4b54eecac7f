// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_laws.hpp"

#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <span>
#include <string>

namespace ionskin {

namespace {

template <class Law>
void check_section(const CaseDocument& document, const std::string& section,
                   std::span<const Law> table, const std::string& law, Problems& problems) {
  const ValueRecord* choice = document.find(section + ".law");
  const bool tries_laws = choice && choice->origin == ValueOrigin::set_edit;
  for (const ValueRecord& record : document.records) {
    // A sweep of laws leaves the parameters of the others in the file.
    if (tries_laws && record.origin == ValueOrigin::file)
      continue;
    if (!record.place || !record.key.starts_with(section + "."))
      continue;
    const std::string name = record.key.substr(section.size() + 1);
    std::string with;
    for (const Law& other : table)
      if (laws::has_parameter(table, other.name, name))
        with += fmt::format("{}\"{}\"", with.empty() ? "" : " or ", other.name);
    if (!with.empty() && !laws::has_parameter(table, law, name))
      problems.add(
          fmt::format("{} is given, but the law \"{}\" has no such parameter", record.key, law),
          {{*record.place, ""}}, fmt::format("set {}.law = {}, or remove the key", section, with));
  }
}

} // namespace

void check_laws(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  check_section(document, "contact", laws::friction_laws(), input.contact.law, problems);
  check_section(document, "coupling", laws::coupling_laws(), input.coupling.law, problems);
}

} // namespace ionskin
