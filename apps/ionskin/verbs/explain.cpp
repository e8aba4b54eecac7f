// SPDX-License-Identifier: Apache-2.0
#include "verbs/explain.hpp"

#include "command_line/threads.hpp"
#include "terminal/terminal.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/elastic_constants.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/cell_circuit.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/planning/contact_estimate.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/poroelasticity/validity.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace ionskin::apps {

namespace {

// Numbers of the first and the last instants that are shown of a path of many waypoints.
constexpr std::size_t most_instants = 16, last_instants = 4;

std::string row(const std::string& name, const std::string& value, const std::string& note = "") {
  return note.empty() ? fmt::format("  {:<34} {}\n", name, value)
                      : fmt::format("  {:<34} {:<13}  {}\n", name, value, note);
}

std::string values(const CaseDocument& document) {
  std::size_t key_width = 0, value_width = 0;
  constexpr std::size_t widest = 60;
  for (const ValueRecord& record : document.records) {
    key_width = std::max(key_width, record.key.size());
    value_width = std::max(value_width, base::shown(record.si, widest).size());
  }
  std::string text = "\nValues in SI units, and where they come from\n";
  for (const ValueRecord& record : document.records)
    text += fmt::format("  {:<{}}  {:<{}}  {}\n", record.key, key_width,
                        base::shown(record.si, widest), value_width, to_string(record.origin));
  return text;
}

std::string scales_of_ions(const Case& input) {
  const double thickness = input.skin.core_thickness();
  const auto scales = electrochemistry::derive_scales(input.electrochemistry, thickness);
  std::string text = "\nScales of the ions\n";
  const auto add = [&text](const std::string& name, const std::string& value,
                           const std::string& note) { text += row(name, value, note); };
  add("thermal voltage", fmt::format("{:.4g} mV", scales.thermal_voltage * 1e3), "R T / F");
  add("Debye length", fmt::format("{:.4g} um", scales.debye_length * 1e6),
      fmt::format("the core is {:.4g} Debye lengths thick", thickness / scales.debye_length));
  add("relaxation time", fmt::format("{:.4g} ms", scales.relaxation_time * 1e3), "lambda^2 / D");
  add("charging time", fmt::format("{:.4g} s", scales.slow_time),
      "lambda h / (2 D), of both double layers through the core");
  add("conductivity", fmt::format("{:.4g} S/m", scales.conductivity), "");
  if (const auto excess = electrochemistry::steric_excess(input.electrochemistry))
    add("thermodynamic factor", fmt::format("{:.4g}", 1 / excess->room(1.0)),
        "of ions of finite size at rest: multiplies D, and lambda by its root");
  add("charge scale", fmt::format("{:.4g} C/m2", scales.charge_density), "F c0 lambda");
  return text;
}

std::string scales_of_water(const Case& input) {
  const auto water = poroelasticity::derive_water_properties(input);
  const double thickness = input.skin.core_thickness();
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  std::string text = "\nScales of the water\n";
  const auto add = [&text](const std::string& name, const std::string& value,
                           const std::string& note) { text += row(name, value, note); };
  add("undrained Poisson's ratio", fmt::format("{:.5g}", core.poissons_ratio),
      fmt::format("materials.{}.poissons_ratio: of the core before its water moves", core.name));
  const double oedometric = drained_oedometric_modulus(input), shear = shear_modulus(core);
  add("drained Poisson's ratio",
      fmt::format("{:.5g}", (oedometric - 2 * shear) / (2 * (oedometric - shear))),
      "of the core once its water has moved");
  add("swelling modulus M", fmt::format("{:.4g} MPa", water.drained_modulus / 1e6),
      bends_freely(input) ? "G / (1 - 2 nu), drained, of a strip that bends freely"
                          : "oedometric, drained");
  add("Skempton's coefficient B", fmt::format("{:.4g}", water.skempton_coefficient),
      "1 - K_d / K_u: nearer to 1 the nearer the undrained ratio is to 0.5");
  add("streaming coefficient L_s", fmt::format("{:.4g} V/Pa", water.streaming_coefficient),
      "n_d V_w / (v F)");
  add("mobility K", fmt::format("{:.4g} m2/(Pa s)", water.mobility), "at zero current");
  add("consolidation coefficient c_v", fmt::format("{:.4g} m2/s", water.consolidation_coefficient),
      "K M M_B / (M + M_B)");
  add("consolidation time", fmt::format("{:.4g} s", water.consolidation_time(thickness)),
      "h^2 / (pi^2 c_v), between sealed walls");
  add("streaming over dilution S", fmt::format("{:.4g}", water.streaming_number()),
      "v L_s M / (theta V_T)");
  const auto hold = poroelasticity::holding(input);
  if (hold.time > 0)
    add("water's share of a touch", fmt::format("{:.4g}", hold.number),
        fmt::format("c_v t / h^2 of {:.4g} s in contact, by {}", hold.time,
                    hold.by_force ? "a force" : "an indentation, sound up to 0.03"));
  return text;
}

/// Lines on the time constants of the first taxel, or line of a crossbar, with each circuit that
/// passes charge.
std::string time_constants_of_taxels(const Readout& readout, double capacitance_per_area) {
  std::string text, last;
  const std::vector<Taxel> lines = readout.lines();
  const std::vector<Taxel>& taxels = lines.empty() ? readout.taxels : lines;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const Taxel& taxel = taxels[i];
    const circuits::Circuit circuit =
        lines.empty() ? circuits::circuit(readout.circuit_of(i), readout.parameters_of(i))
                      : circuits::circuit(taxel.circuit, readout.parameters);
    if ((lines.empty() && !readout.has_own_circuit(i)) || circuit.words == last)
      continue;
    last = circuit.words;
    const double capacitance = capacitance_per_area * (taxel.upper[0] - taxel.lower[0]) *
                               (taxel.upper[1] - taxel.lower[1]);
    if (circuit.admittance && std::isfinite(circuit.admittance->resistance))
      text +=
          row(fmt::format("time constant of {} {}", lines.empty() ? "taxel" : "line", taxel.name),
              fmt::format("{:.4g} s", circuit.admittance->resistance *
                                          (capacitance + circuit.admittance->capacitance)),
              fmt::format("through its {}", circuit.words));
  }
  return text;
}

/// Longest time for which the slider presses without a break [s].
double time_of_touch(const Case& input) {
  if (input.strain.kind == StrainSourceKind::prescribed)
    return input.strain.duration;
  double longest = 0, now = 0;
  if (input.strain.kind == StrainSourceKind::contact)
    for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
      now = leg.touches() ? (leg.lands() ? 0 : now) + contact_part(leg).duration : 0;
      longest = std::max(longest, now);
    }
  return longest;
}

/// Line on the effect that electrodes of a usual sheet resistance would have, where the case gives
/// none.
std::string metal(const Case& input, const electrochemistry::CellCircuit& cell) {
  constexpr double usual = 1.0;       // of either metal [ohm]
  constexpr double comparable = 0.05; // of a touch
  const double squares = cell.metal_squares;
  if (squares > 0)
    return row("resistance of the metal",
               fmt::format("{:.4g} ohm", squares * input.skin.length / input.skin.width),
               "of both electrodes from end to end") +
           row("charging along the metal", fmt::format("{:.4g} s", cell.metal_time(squares)),
               "metal and double layers, up to the place farthest from the leads");
  if (input.readout.contact == ElectrodeContact::everywhere || !input.readout.taxels.empty() ||
      input.electrochemistry.ion_model == IonModel::thin_layers)
    return "";
  const double time = cell.metal_time(2 * usual), touch = time_of_touch(input);
  std::string text = row("charging along the metal", fmt::format("{:.4g} s", time),
                         fmt::format("if each metal had {:.2g} ohm a square; 0 is taken, as no "
                                     "skin.layers[].sheet_resistance is given",
                                     usual));
  if (time > comparable * touch && touch > 0)
    text += paragraph(
        fmt::format("warning: thin metal would delay and lower the current: with {:.2g} ohm a "
                    "square charge takes {:.2g} s along it, and a touch lasts {:.2g} s. Give "
                    "skin.layers[].sheet_resistance of both electrodes, or readout.contact = "
                    "\"everywhere\" where leads touch them all over.",
                    usual, time, touch),
        2);
  return text;
}

/// Lines on the scales of charging and discharging in the cell; the circuit decides which of them
/// is read.
std::string scales_of_readout(const Case& input) {
  const electrochemistry::CellCircuit cell = electrochemistry::cell_circuit(input);
  const double face = input.skin.length * input.skin.width, per_area = cell.layers / face;
  const Readout& readout = input.readout;
  std::string text = "\nReadout\n";
  text += row("capacitance of the cell C", fmt::format("{:.4g} F", cell.layers),
              "of both double layers in series, at low frequency and small voltage");
  text += row("geometric capacitance", fmt::format("{:.4g} F", cell.geometric),
              "of the core as a dielectric, for what is faster than its screening");
  text += row("resistance of the core", fmt::format("{:.4g} ohm", cell.core), "h / (sigma A)");
  text += row("screening within the core", fmt::format("{:.4g} s", cell.screening),
              "core and geometric capacitance: an open voltage decays so, behind any circuit");
  text += row("charging through the core", fmt::format("{:.4g} s", cell.charging),
              "core and double layers: the current of a short circuit or an amplifier decays so");
  text += metal(input, cell);
  if (!readout.taxels.empty()) {
    const Taxel& first = readout.taxels.front();
    const double area = (first.upper[0] - first.lower[0]) * (first.upper[1] - first.lower[1]);
    text += row(fmt::format("capacitance below taxel {}", first.name),
                fmt::format("{:.4g} F", per_area * area),
                fmt::format("the first of {}", readout.taxels.size()));
  }
  const circuits::Circuit circuit = circuits::circuit(readout.circuit, readout.parameters);
  if (circuit.admittance && std::isfinite(circuit.admittance->resistance)) {
    const double resistance = circuit.admittance->resistance,
                 beside = circuit.admittance->capacitance;
    const char* of = readout.taxels.empty() ? ""
                     : readout.is_cut()     ? ", of what has no circuit of its own"
                                            : ", which all taxels share";
    text +=
        row("time constant R C", fmt::format("{:.4g} s", resistance * (cell.layers + beside)),
            fmt::format("double layers through the {}{}: what the screening leaves of a voltage "
                        "decays so",
                        circuit.words, of));
    const double faster = resistance * (cell.geometric + beside);
    if (faster < cell.screening)
      text += row("geometric time constant", fmt::format("{:.4g} s", faster),
                  fmt::format("the {}{} takes a voltage away sooner than the core screens it",
                              circuit.words, of));
  }
  text += time_constants_of_taxels(readout, per_area);
  return text;
}

/// Lines on the contact of a round slider, whose area is not known before it is solved.
std::string scales_of_round_contact(const Case& input) {
  const mesh::Footprint largest = mesh::largest_footprint(input);
  std::string text = "\nContact\n";
  if (input.motion.force_controlled())
    text += row("normal force", fmt::format("{:.3g} N", input.motion.preload_force));
  return text + row("contact at most",
                    fmt::format("{:.3g} mm x {:.3g} mm", 2e3 * largest.half_size[0],
                                2e3 * largest.half_size[1]),
                    "the mesh is fitted to the contact that a coarse solution finds");
}

std::string scales_of_contact(const Case& input) {
  if (!input.slider.sharp())
    return scales_of_round_contact(input);
  const planning::ContactEstimate estimate = planning::estimate_contact(input);
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const double nonlinearity =
      electrochemistry::nonlinearity(scales, input.coupling.coefficient, estimate.shear);
  std::string text = "\nContact, estimated from above (layers that cannot move sideways)\n";
  text += row("mean pressure", fmt::format("{:.3g} MPa", estimate.pressure * 1e-6));
  text += row("normal force", fmt::format("{:.3g} N", estimate.pressure * estimate.area));
  text += row("shear under the sliding slider", fmt::format("{:.3g}", estimate.shear));
  text += row("nonlinearity k gamma h/(2 lambda)", fmt::format("{:.3g}", nonlinearity),
              "the ions respond linearly far below 1");
  return text;
}

// Names of what begins at each instant of a cycle.
std::vector<std::pair<std::string, double>> instants(const std::vector<MotionLeg>& legs) {
  std::vector<std::pair<std::string, double>> result;
  for (const MotionLeg& leg : legs) {
    const ContactPart part = contact_part(leg);
    const bool known = !leg.from_level.is_force && !leg.to_level.is_force;
    if (leg.lands() && known)
      result.emplace_back("contact", leg.begin + part.begin);
    if (leg.phase == Phase::slide)
      result.emplace_back(leg.slides() ? "slide begins" : "hold begins", leg.begin);
    if (leg.leaves())
      result.emplace_back("lift-off begins", leg.begin);
    if (leg.leaves() && known)
      result.emplace_back("contact lost", leg.begin + part.begin + part.duration);
    if (leg.phase == Phase::return_)
      result.emplace_back("return begins", leg.begin);
  }
  return result;
}

/// Text on the events from `begin` to before `end`: "480 x slide begins, 3 x contact".
std::string kinds(const std::vector<std::pair<std::string, double>>& all, std::size_t begin,
                  std::size_t end) {
  std::map<std::string, std::size_t> counts;
  for (std::size_t i = begin; i < end; ++i)
    ++counts[all[i].first];
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", count, what);
  return text;
}

std::string events(const Case& input) {
  const Motion& motion = input.motion;
  std::string text = fmt::format(
      "\nInstants of each cycle of {:.6g} s; the run has {} and lasts {:.6g} s\n",
      motion.cycle_duration(), motion.cycles == 1 ? "one" : std::to_string(motion.cycles),
      motion.cycles * motion.cycle_duration());
  const auto all = instants(motion_legs(motion, input.slider));
  const std::size_t left_out = all.size() > most_instants ? all.size() - most_instants : 0;
  const std::size_t first_left_out = most_instants - last_instants;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (left_out > 0 && i == first_left_out) {
      text += row("...", fmt::format("{} more", left_out), kinds(all, i, i + left_out));
      i += left_out;
    }
    text += row(all[i].first, fmt::format("{:.8g} s", all[i].second));
  }
  return text;
}

std::string costs(const planning::CostEstimate& cost) {
  std::string text = "\nSize and cost\n";
  if (cost.contact_cells > 0)
    text += row("Study 1: unknowns", fmt::format("{}", 3 * cost.contact_cells),
                fmt::format("forces on {} contact cells, over about {} steps", cost.contact_cells,
                            cost.contact_steps));
  text += row("Study 2: unknowns", fmt::format("{}", cost.ion_unknowns),
              fmt::format("over about {} time steps", cost.ion_steps));
  text += row("memory", fmt::format("{:.2g} GB", cost.memory * 1e-9),
              "largest, estimated from the unknowns");
  text += row("files", base::byte_text(cost.output), "of the results, estimated likewise");
  text += row("wall time", fmt::format("{:.2g} s", cost.seconds),
              fmt::format("with {} threads, from costs per unknown measured on one machine",
                          thread_count(0)));
  return text;
}

} // namespace

std::string warnings_of_water(const Case& input) {
  std::string text;
  if (moves_water(input))
    for (const std::string& warning : poroelasticity::validity_warnings(input))
      text += paragraph("warning: " + warning, 2);
  return text;
}

std::string explain(const CaseDocument& document, const planning::CostEstimate& cost) {
  const Case& input = document.input;
  std::string text = values(document) + scales_of_ions(input) +
                     (moves_water(input) ? scales_of_water(input) : "") + scales_of_readout(input);
  if (input.strain.kind == StrainSourceKind::contact) {
    const std::vector<Case> sliders = cases_of_sliders(input);
    for (std::size_t i = 0; i < sliders.size(); ++i) {
      text += sliders.size() > 1 ? fmt::format("\nslider[{}]\n", i) : "";
      text += scales_of_contact(sliders[i]) + events(sliders[i]);
    }
  }
  return text + costs(cost);
}

} // namespace ionskin::apps
