// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_readout.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/document/taxel_grid.hpp"
#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/circuits/circuit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace ionskin {

namespace {

/// Name, in output, of the part of the electrode that no taxel covers; no taxel may have it.
constexpr const char* rest_name = "rest";

std::string taxel_key(std::size_t taxel, const std::string& property) {
  return fmt::format("readout.taxels[{}].{}", taxel, property);
}

std::vector<Pointer> places(const CaseDocument& document, std::size_t first,
                            const std::string& property, std::size_t second) {
  std::vector<Pointer> all = document.point_at(taxel_key(first, property), "first");
  for (const Pointer& pointer : document.point_at(taxel_key(second, property), "second"))
    all.push_back(pointer);
  return all;
}

bool is_column_name(const std::string& name) {
  return !name.empty() && name != rest_name && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

void check_rectangle(const CaseDocument& document, std::size_t index, Problems& problems) {
  const Taxel& taxel = document.input.readout.taxels[index];
  const std::array<double, 2> size{document.input.skin.length, document.input.skin.width};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double low = taxel.lower[axis] * 1e3, high = taxel.upper[axis] * 1e3;
    const char* direction = axis == 0 ? "x" : "y";
    if (low >= high)
      problems.add(fmt::format("the taxel \"{}\" has no extent along {}: it reaches from {:.6g} mm "
                               "to {:.6g} mm",
                               base::shown(taxel.name), direction, low, high),
                   document.point_at(taxel_key(index, "upper")),
                   "upper must be greater than lower along x and along y");
    else if (taxel.upper[axis] > size[axis] * (1 + 1e-12))
      problems.add(
          fmt::format("the taxel \"{}\" leaves the top face: it reaches to {:.6g} mm along "
                      "{}, the skin to {:.6g} mm",
                      base::shown(taxel.name), high, direction, size[axis] * 1e3),
          document.point_at(taxel_key(index, "upper")),
          fmt::format("it must be at most {:.6g} mm along {}", size[axis] * 1e3, direction));
  }
}

bool overlap(const Taxel& first, const Taxel& second) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double rounding = 1e-9 * (first.upper[axis] - first.lower[axis]);
    if (first.upper[axis] <= second.lower[axis] + rounding ||
        second.upper[axis] <= first.lower[axis] + rounding)
      return false;
  }
  return true;
}

/// The first pair of taxels that conflict, and the number of all such pairs.
struct Conflicts {
  std::size_t first = 0, second = 0, count = 0;

  void add(std::size_t one, std::size_t other) {
    if (count++ == 0)
      first = one, second = other;
  }
  std::string others() const {
    return count < 2 ? "" : fmt::format("; so do {} more pairs", count - 1);
  }
};

void check_pairs(const CaseDocument& document, Problems& problems) {
  const std::vector<Taxel>& taxels = document.input.readout.taxels;
  Conflicts names, places_taken;
  for (std::size_t i = 0; i < taxels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (taxels[i].name == taxels[j].name)
        names.add(j, i);
      if (overlap(taxels[j], taxels[i]))
        places_taken.add(j, i);
    }
  if (names.count > 0)
    problems.add(fmt::format("two taxels have the name \"{}\"{}",
                             base::shown(taxels[names.first].name), names.others()),
                 places(document, names.first, "name", names.second),
                 "give every taxel a name of its own");
  if (places_taken.count > 0)
    problems.add(fmt::format("the taxels \"{}\" and \"{}\" overlap{}",
                             base::shown(taxels[places_taken.first].name),
                             base::shown(taxels[places_taken.second].name), places_taken.others()),
                 places(document, places_taken.first, "lower", places_taken.second),
                 "move their corners apart: charge belongs to one taxel only");
}

/// A given key that no chosen circuit uses, and the names of the circuits that have it.
struct IdleKey {
  std::string key, circuits;
};

/// True if the circuit of the electrode, of crossbar rows or of any taxel has the parameter.
bool is_used(const Readout& readout, std::string_view parameter) {
  const auto table = circuits::circuits();
  bool used = laws::has_parameter(table, readout.circuit, parameter) ||
              (readout.is_crossbar() && laws::has_parameter(table, readout.row_circuit, parameter));
  for (std::size_t i = 0; i < readout.taxels.size() && !used; ++i)
    used = laws::has_parameter(table, readout.circuit_of(i), parameter);
  return used;
}

/// Finds the given keys that no chosen circuit uses.
std::vector<IdleKey> idle_keys(const CaseDocument& document) {
  const auto table = circuits::circuits();
  std::vector<IdleKey> idle;
  for (const circuits::CircuitRow& circuit : table)
    for (const laws::LawParameter& parameter : circuit.parameters) {
      const std::string key = fmt::format("readout.{}", parameter.name);
      if (!document.point_at(key).empty() &&
          std::ranges::find(idle, key, &IdleKey::key) == idle.end() &&
          !is_used(document.input.readout, parameter.name))
        idle.push_back({key, laws_with_parameter(table, parameter.name)});
    }
  return idle;
}

bool names_circuit(const CaseDocument& document) {
  return !document.point_at("readout.circuit").empty() ||
         !document.point_at("readout.taxel_circuit").empty() || document.input.readout.is_cut();
}

/// Largest number of conductors on the top face, whose potentials are a dense system of equations;
/// and smallest size of a conductor over the size of the skin, because the transport grid has
/// lateral columns of this size along the whole skin.
constexpr std::size_t most_conductors = 400;
constexpr double least_conductor = 0.01;

/// Checks that the parameters that a taxel gives belong to a circuit of its own.
void check_parameters(const CaseDocument& document, std::size_t index, Problems& problems) {
  const Readout& readout = document.input.readout;
  const auto table = circuits::circuits();
  for (const auto& [name, value] : readout.taxels[index].parameters)
    if (!laws::has_parameter(table, readout.circuit_of(index), name) ||
        !readout.has_own_circuit(index))
      problems.add(
          fmt::format("the taxel \"{}\" has {}, but its circuit has none",
                      base::shown(readout.taxels[index].name), name),
          document.point_at(taxel_key(index, name)),
          fmt::format("give it circuit = {}, or remove the key", laws_with_parameter(table, name)));
}

void check_size(const CaseDocument& document, std::size_t index, Problems& problems) {
  const Taxel& taxel = document.input.readout.taxels[index];
  const std::array<double, 2> face{document.input.skin.length, document.input.skin.width};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double size = taxel.upper[axis] - taxel.lower[axis];
    if (size > 0 && size < least_conductor * face[axis])
      problems.add(
          fmt::format("the taxel \"{}\" is too small for a circuit of its own: {:.4g} mm along {}",
                      base::shown(taxel.name), size * 1e3, axis == 0 ? "x" : "y"),
          document.point_at(taxel_key(index, "upper")),
          fmt::format("it must be at least {:.4g} mm, a hundredth of the skin, or share the "
                      "circuit of the electrode: circuit = \"shared\"",
                      least_conductor * face[axis] * 1e3));
  }
}

/// Checks taxels that are conductors of their own, with circuits of their own.
void check_conductors(const CaseDocument& document, Problems& problems) {
  const Readout& readout = document.input.readout;
  std::size_t count = 0;
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    check_parameters(document, i, problems);
    if (readout.has_own_circuit(i)) {
      ++count;
      check_size(document, i, problems);
    }
  }
  if (count > most_conductors && !readout.is_crossbar())
    problems.add(fmt::format("{} taxels have circuits of their own", count),
                 document.point_at("readout.taxel_circuit"),
                 fmt::format("at most {} may: use fewer taxels, or taxel_circuit = \"shared\"",
                             most_conductors));
  if (readout.taxels.empty() && !document.point_at("readout.taxel_circuit").empty() &&
      readout.taxel_circuit != shared_circuit)
    problems.add("readout.taxel_circuit is given, but the case has no taxels",
                 document.point_at("readout.taxel_circuit"),
                 "add taxels, such as readout.taxels = {rows = 2, columns = 4}, or remove the key");
  if (count > 0 && !readout.is_crossbar() &&
      circuits::circuit(readout.circuit, readout.parameters).read)
    problems.add(fmt::format("the instrument of readout.circuit = \"{}\" reads one electrode, and "
                             "taxels have circuits of their own",
                             readout.circuit),
                 document.point_at("readout.circuit"),
                 fmt::format("set readout.circuit = \"short\" for what is between the taxels; "
                             "readout.taxel_circuit = \"{}\" reads each of them",
                             readout.circuit));
  if (count > 0 && document.input.electrochemistry.ion_model == IonModel::thin_layers)
    problems.add(
        "the ion model \"thin-layers\" supports only one conductor as the top electrode, and "
        "taxels have circuits of their own here",
        document.point_at("electrochemistry.ion_model"),
        readout.is_crossbar()
            ? "set electrochemistry.ion_model = \"dilute\", or remove "
              "readout.taxels.wiring"
            : "set electrochemistry.ion_model = \"dilute\", or readout.taxel_circuit = "
              "\"shared\"");
}

/// Refuses keys of circuits in a case that names no circuit: the user probably forgot to name it.
/// If the case names one, such keys are only noted (`notes_on_readout`).
void check_circuit(const CaseDocument& document, Problems& problems) {
  if (names_circuit(document))
    return;
  for (const IdleKey& one : idle_keys(document))
    problems.add(fmt::format("{} is given, but the circuit has none", one.key),
                 document.point_at(one.key),
                 fmt::format("set readout.circuit = {}, or remove the key", one.circuits));
}

void check_scan(const CaseDocument& document, Problems& problems) {
  const Readout& readout = document.input.readout;
  const std::vector<Pointer> others = document.point_at("readout.scan.others");
  if (readout.scan.dwell == 0) {
    if (!others.empty())
      problems.add("readout.scan.others is given, but nothing is scanned", others,
                   "add readout.scan.dwell, the time on a row, or remove the key");
    return;
  }
  if (!readout.is_cut())
    problems.add("readout.scan reads taxels row by row, but none has a circuit of its own",
                 document.point_at("readout.scan.dwell"),
                 "set readout.taxel_circuit, such as \"short\" or \"load\", beside readout.taxels");
}

void check_grid(const CaseDocument& document, Problems& problems) {
  const TaxelGrid& grid = document.input.readout.taxel_grid;
  const std::string key = "readout.taxels.";
  std::vector<Pointer> given;
  for (const char* name : {"rows", "columns", "gap", "wiring"})
    for (const Pointer& pointer : document.point_at(key + name))
      given.push_back(pointer);
  if (given.empty())
    return;
  for (const char* name : {"rows", "columns"})
    if (document.point_at(key + name).empty())
      problems.add(fmt::format("missing key {}{} of the grid of taxels", key, name), given,
                   "a grid has both: taxels = {rows = 2, columns = 4}");
  if (grid.rows < 1 || grid.columns < 1)
    return;
  const Skin& skin = document.input.skin;
  const std::array<double, 2> size = taxel_size(grid, skin), face{skin.length, skin.width};
  const std::array<int, 2> count{grid.columns, grid.rows};
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (size[axis] <= 0)
      problems.add(fmt::format("the gaps leave no room for the taxels along {}: {} of {:.6g} mm on "
                               "{:.6g} mm",
                               axis == 0 ? "x" : "y", count[axis] - 1, grid.gap * 1e3,
                               face[axis] * 1e3),
                   document.point_at(key + "gap"),
                   fmt::format("it must be below {:.6g} mm, or the taxels fewer",
                               face[axis] * 1e3 / (count[axis] - 1)));
}

} // namespace

void check_readout(const CaseDocument& document, Problems& problems) {
  check_circuit(document, problems);
  check_grid(document, problems);
  const std::vector<Taxel>& taxels = document.input.readout.taxels;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    if (!is_column_name(taxels[i].name))
      problems.add(fmt::format("\"{}\" cannot name a taxel", base::shown(taxels[i].name)),
                   document.point_at(taxel_key(i, "name")),
                   "use letters, digits, _ and -; \"rest\" is what no taxel covers");
    check_rectangle(document, i, problems);
  }
  check_pairs(document, problems);
  check_conductors(document, problems);
  check_scan(document, problems);
}

std::vector<std::string> notes_on_readout(const CaseDocument& document) {
  std::vector<std::string> notes;
  const Readout& readout = document.input.readout;
  for (const IdleKey& one : idle_keys(document))
    notes.push_back(fmt::format("{} is given and not used: the circuit \"{}\" has none, {} has.",
                                one.key, readout.circuit, one.circuits));
  const circuits::Circuit circuit = circuits::circuit(readout.circuit, readout.parameters);
  if (readout.taxels.empty() || readout.is_cut() || !circuit.admittance)
    return notes;
  if (circuit.admittance->passes_charge())
    notes.push_back(fmt::format(
        "All {} taxels share one {} and one voltage: with the circuit \"{}\" the top electrode is "
        "one conductor, and taxels.csv has the part of the current that enters each. Taxels read "
        "one by one have circuits of their own: readout.taxel_circuit.",
        readout.taxels.size(), circuit.words, circuit.name));
  else
    notes.push_back(fmt::format(
        "All taxels share one voltage: with the circuit \"{}\" the top electrode is one "
        "conductor, and the currents of the taxels flow from one to another. For voltages of "
        "their own set readout.taxel_circuit.",
        circuit.name));
  return notes;
}

} // namespace ionskin
