// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_electrochemistry.hpp"

#include <fmt/format.h>

namespace ionskin {

void check_electrochemistry(const CaseDocument& document, Problems& problems) {
  const Electrochemistry& ions = document.input.electrochemistry;
  const std::vector<Pointer> given = document.point_at("electrochemistry.largest_concentration");
  if (given.empty())
    return;
  if (ions.ion_model == IonModel::dilute) {
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
