// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_electrochemistry.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"

#include <fmt/format.h>

#include <cmath>

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

/// Thickness of both interfaces together in Debye lengths, 8 at each wall as in the solver, and
/// their largest share of the thickness of the core.
constexpr double interface_lengths = 16, interface_share = 0.01;

void check_interface(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const Electrochemistry& ions = input.electrochemistry;
  if (ions.interface_capacitance == 0 || ions.permittivity == 0 ||
      ions.fixed_charge_concentration == 0 || ions.temperature == 0)
    return;
  const std::vector<Pointer> at = document.point_at("electrochemistry.interface_capacitance");
  if (laws::coupling_law(input.coupling.law).traits.makes_net_charge)
    problems.add(
        fmt::format("coupling.law = \"{}\" makes net charge in proportion to the volume "
                    "of the core, of which interfaces with an area of their own have more "
                    "than the skin",
                    input.coupling.law),
        at,
        "choose a law that conserves charge, such as coupling.law = \"column-neutral\", or "
        "remove electrochemistry.interface_capacitance");
  const double charge = constants::faraday * ions.fixed_charge_concentration,
               scale =
                   constants::gas_constant * ions.temperature / (ions.valence * constants::faraday);
  const double crowded = ions.ion_model == IonModel::steric && ions.largest_concentration > 0
                             ? 1 - ions.resting_concentration() / ions.largest_concentration
                             : 1;
  const double least = std::sqrt(ions.permittivity * charge / scale * std::max(crowded, 0.0));
  const double fitting = ions.permittivity * std::pow(ions.interface_capacitance / least, 2);
  if (ions.interface_capacitance < least * (1 - 1e-9)) {
    // No material has less than the permittivity of vacuum; the bulk of a wet polymer has up to 80
    // times that.
    const std::string remedy =
        fitting >= constants::vacuum_permittivity
            ? fmt::format("set electrochemistry.permittivity to that of the bulk, at most {:.3g} "
                          "F/m here (80 times that of vacuum is 7.1e-10 F/m)",
                          fitting)
            : fmt::format("the capacitance is too small for these ions: with a permittivity of "
                          "7.1e-10 F/m, 80 times that of vacuum, it must be at least {:.3g} F/m2",
                          least * std::sqrt(7.1e-10 / ions.permittivity));
    problems.add(
        fmt::format("electrochemistry.interface_capacitance = {:.4g} F/m2 is less than the {:.4g} "
                    "F/m2 that a permittivity of {:.4g} F/m makes of the projected area alone",
                    ions.interface_capacitance, least, ions.permittivity),
        at, remedy);
  } else if (const double layers =
                 interface_lengths * std::sqrt(ions.permittivity * scale / charge);
             ions.ion_model != IonModel::thin_layers &&
             layers > interface_share * input.skin.core_thickness())
    problems.add(
        fmt::format(
            "at a permittivity of {:.4g} F/m the double layers take {:.3g} of the core, and "
            "an area of their own would change its resistance",
            ions.permittivity, layers / input.skin.core_thickness()),
        at,
        fmt::format(
            "set electrochemistry.permittivity to that of the bulk, at most {:.3g} F/m here",
            ions.permittivity *
                std::pow(interface_share * input.skin.core_thickness() / layers, 2)));
}

} // namespace

void check_electrochemistry(const CaseDocument& document, Problems& problems) {
  check_thin_layers(document, problems);
  check_interface(document, problems);
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
