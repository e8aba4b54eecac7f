// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_drive.hpp"

#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ionskin {

namespace {

bool is_given(const CaseDocument& document, const std::string& key) {
  const ValueRecord* record = document.find(key);
  return record != nullptr && record->place.has_value();
}

/// True if the friction law gives less friction at high speed than at rest.
bool weakens(const Contact& contact) {
  const auto parameters = laws::friction_law(contact.law).parameters;
  if (!std::ranges::all_of(parameters, [&](const laws::LawParameter& own) {
        return contact.parameters.contains(own.name);
      })) {
    return false; // `complete` reports missing parameters
  }
  constexpr double pressure = 1, fast = 1e9; // [Pa], [m/s]
  const laws::Friction friction = laws::friction(contact.law, contact.friction, contact.parameters);
  return friction.lag > 0 &&
         friction.limit({pressure, fast, 1, fast}) < friction.limit({pressure, 0, 1, 0});
}

} // namespace

void check_drive(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const Drive& drive = input.motion.drive;
  if (!drive.given()) {
    for (const std::string key : {"motion.drive.damping", "motion.drive.mass"})
      if (is_given(document, key))
        problems.add(fmt::format("{} is given, but the drive has no spring", key),
                     document.point_at(key), "give motion.drive.stiffness, or remove it");
    return;
  }
  if (!weakens(input.contact))
    return;
  if (drive.mass == 0 && drive.damping == 0)
    problems.add(
        fmt::format("contact.law = \"{}\" falls with speed, and the drive has neither mass nor "
                    "damping: where the slider slips nothing says how fast it goes",
                    input.contact.law),
        document.point_at("motion.drive.stiffness"),
        "give motion.drive.mass or motion.drive.damping, or raise contact.kinetic_friction to "
        "contact.friction");
  // Stick-slip may repeat as often as once in each natural period.
  constexpr double most_periods = 1e5;
  const double periods =
      drive.mass > 0 ? input.motion.cycle_duration() / drive.natural_period() : 0;
  if (periods > most_periods)
    problems.add(fmt::format("the slider may stick and slip {:.3g} times in a cycle of {:.4g} s, "
                             "at the natural period of its drive of {:.3g} ms; at most {:.0g} "
                             "are allowed",
                             periods, input.motion.cycle_duration(), drive.natural_period() * 1e3,
                             most_periods),
                 document.point_at("motion.drive.mass"),
                 "raise motion.drive.mass, lower motion.drive.stiffness, or shorten the motion");
}

} // namespace ionskin
