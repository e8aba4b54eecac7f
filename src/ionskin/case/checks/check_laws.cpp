// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_laws.hpp"

#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

namespace ionskin {

namespace {

template <class Law>
void check_section(const CaseDocument& document, const std::string& section,
                   std::span<const Law> table, const std::string& law, Problems& problems) {
  for (const ValueRecord& record : document.records) {
    if (!record.place || !record.key.starts_with(section + "."))
      continue;
    const std::string name = record.key.substr(section.size() + 1);
    const std::string with = laws_with_parameter(table, name);
    if (!with.empty() && !laws::has_parameter(table, law, name))
      problems.add(
          fmt::format("{} is given, but the law \"{}\" has no such parameter", record.key, law),
          {{*record.place, ""}}, fmt::format("set {}.law = {}, or remove the key", section, with));
  }
}

bool is_complete(const laws::FrictionLaw& row, const laws::LawValues& given) {
  return std::ranges::all_of(
      row.parameters, [&](const laws::LawParameter& own) { return given.contains(own.name); });
}

} // namespace

void check_laws(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  check_section(document, "contact", laws::friction_laws(), input.contact.law, problems);
  check_section(document, "coupling", laws::coupling_laws(), input.coupling.law, problems);
}

void check_friction_of_speed(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const laws::FrictionLaw& row = laws::friction_law(input.contact.law);
  if (!is_complete(row, input.contact.parameters)) // `complete` reports missing parameters
    return;
  double fastest = 0;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider))
    if (leg.slides() && leg.duration > 0)
      fastest = std::max(fastest, leg.length() / leg.duration);
  constexpr double pressure = 1; // [Pa]; friction coefficient = limit / pressure
  const laws::Friction friction =
      laws::friction(input.contact.law, input.contact.friction, input.contact.parameters);
  const double coefficient = friction.limit({pressure, fastest, 1, fastest}) / pressure;
  const double most = find_row("contact.friction")->range.upper;
  if (coefficient > most)
    problems.add(
        fmt::format("at {:.4g} mm/s, the fastest of the motion, contact.law = \"{}\" has a "
                    "coefficient of friction of {:.4g}; at most {:.4g} is allowed",
                    fastest * 1e3, input.contact.law, coefficient, most),
        document.point_at("contact.law"),
        "lower contact.friction or the speed of the motion, or change the parameters of "
        "the law");
}

void check_adhesion(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const laws::FrictionLaw& row = laws::friction_law(input.contact.law);
  if (!row.adheres || !is_complete(row, input.contact.parameters))
    return;
  if (input.motion.drive.given())
    problems.add(
        fmt::format("contact.law = \"{}\" does not support a slider on a drive", input.contact.law),
        document.point_at("motion.drive.stiffness"),
        "remove motion.drive, or choose another contact.law");
  const double range =
      laws::friction(input.contact.law, input.contact.friction, input.contact.parameters)
          .adhesion.range;
  if (range >= input.skin.thickness())
    problems.add(
        fmt::format("slider and skin pull each other over {:.4g} mm, twice "
                    "contact.work_of_adhesion over contact.cohesive_strength, and the skin "
                    "is {:.4g} mm thick",
                    range * 1e3, input.skin.thickness() * 1e3),
        document.point_at("contact.cohesive_strength"),
        "raise contact.cohesive_strength, or lower contact.work_of_adhesion");
}

} // namespace ionskin
