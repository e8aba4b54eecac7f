// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_electrochemistry.hpp"

#include "ionskin/case/coupling.hpp"

#include <fmt/format.h>

namespace ionskin {

namespace {

void check_thin_layers(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  if (input.electrochemistry.ion_model != IonModel::thin_layers)
    return;
  if (!moves_water(input))
    problems.add(
        fmt::format("electrochemistry.ion_model = \"thin-layers\" holds where water drives "
                    "the cations, not under coupling.law = \"{}\"",
                    input.coupling.law),
        document.point_at("electrochemistry.ion_model"),
        "set coupling.law = \"poroelastic\", or ion_model = \"dilute\"");
  if (!input.output.fields.empty())
    problems.add("output.fields is given, but thin layers have no fields",
                 document.point_at("output.fields"),
                 "set output.fields = [], or ion_model = \"dilute\"");
}

} // namespace

void check_electrochemistry(const CaseDocument& document, Problems& problems) {
  check_thin_layers(document, problems);
  const Electrochemistry& ions = document.input.electrochemistry;
  const std::vector<Pointer> given = document.point_at("electrochemistry.largest_concentration");
  if (given.empty())
    return;
  if (ions.ion_model != IonModel::steric) {
    problems.add("electrochemistry.largest_concentration is given, but dilute ions have none",
                 given, "set electrochemistry.ion_model = \"steric\", or remove the key");
  } else if (ions.largest_concentration <= ions.resting_concentration()) {
    problems.add(
        fmt::format("the cations at rest do not fit into the core: their concentration is {:.6g} "
                    "mol/m3, electrochemistry.largest_concentration is {:.6g} mol/m3",
                    ions.resting_concentration(), ions.largest_concentration),
        given,
        fmt::format("it must exceed {:.6g} mol/m3, the fixed charge over the valence",
                    ions.resting_concentration()));
  }
}

} // namespace ionskin
