// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/case/schema/schema_setters.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/circuits/instruments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ionskin {

using units::Dimension;

namespace {

void add_circuit(SchemaRows& rows) {
  const auto table = circuits::circuits();
  rows.push_back({.key = "readout.circuit",
                  .type = ValueType::choice,
                  .default_value = fmt::format("\"{}\"", table.front().name),
                  .choices = choices_of(table),
                  .help = fmt::format("What joins the electrodes: {}.",
                                      alternatives(table, &circuits::CircuitRow::meaning)),
                  .source = "the paper's electrodes are at one potential",
                  .set = into(&Case::readout, &Readout::circuit)});
  add_law_parameters(rows, LawSection{"readout", "circuit", &Case::readout, &Readout::circuit},
                     table, Need::always, true);
}

/// Names of the circuits that a taxel may have: all circuits, and "shared", which makes it part of
/// the electrode.
std::vector<Choice> circuits_of_taxels() {
  std::vector<Choice> choices = choices_of(circuits::circuits());
  choices.insert(choices.begin(), {shared_circuit});
  return choices;
}

/// Appends the keys by which one taxel gets a circuit and parameters of its own. Where it gives
/// none, it takes those of the readout.
void add_circuit_of_taxel(SchemaRows& rows) {
  rows.push_back({.key = "readout.taxels[].circuit",
                  .type = ValueType::choice,
                  .need = Need::where_known,
                  .choices = circuits_of_taxels(),
                  .help = "Joins this taxel to the bottom electrode, instead of "
                          "readout.taxel_circuit.",
                  .set = into_taxel(&Taxel::circuit)});
  const std::size_t own = rows.size();
  const auto table = circuits::circuits();
  for (const circuits::CircuitRow& circuit : table)
    for (const laws::LawParameter& parameter : circuit.parameters) {
      const std::string name(parameter.name), key = "readout.taxels[]." + name;
      if (std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(own), rows.end(),
                      [&](const SchemaRow& row) { return row.key == key; }))
        continue;
      rows.push_back(
          {.key = key,
           .type = type_of(parameter),
           .dimension = parameter.dimension,
           .range = {parameter.lowest, parameter.highest, true, true},
           .need = Need::where_known,
           .help = fmt::format("Of this taxel, instead of readout.{}. Of the circuit {}.", name,
                               laws_with_parameter(table, name)),
           .set = [name](CaseDraft& draft, const KeyIndex& index, const Value& value) {
             draft.input.readout.taxels[index.entry].parameters[name] = value.numbers[0];
           }});
    }
}

void add_electrode_contact(SchemaRows& rows) {
  rows.push_back(
      {.key = "readout.contact",
       .type = ValueType::choice,
       .default_value = "\"one end\"",
       .choices = {{"everywhere"}, {"one end"}, {"both ends"}, {"corner"}},
       .help = "Where leads touch the metal of both electrodes, which matters where it has a "
               "skin.layers[].sheet_resistance: all over, along the end at x = 0, along both "
               "ends, or along the first quarter of the end at x = 0, from y = 0 on.",
       .source = "strips are clamped at one end",
       .set = into<Readout, ElectrodeContact>(&Case::readout, &Readout::contact,
                                              {{"everywhere", ElectrodeContact::everywhere},
                                               {"one end", ElectrodeContact::one_end},
                                               {"both ends", ElectrodeContact::both_ends},
                                               {"corner", ElectrodeContact::corner}})});
}

void add_taxel_circuit(SchemaRows& rows) {
  rows.push_back({.key = "readout.taxel_circuit",
                  .type = ValueType::choice,
                  .default_value = fmt::format("\"{}\"", shared_circuit),
                  .choices = circuits_of_taxels(),
                  .help = "What joins every taxel to the bottom electrode, which makes it a "
                          "conductor of its own: a circuit as of readout.circuit, with the same "
                          "keys. \"shared\": the taxels are parts of one conductor, with the "
                          "circuit of the electrode.",
                  .source = "the paper's electrode is one conductor",
                  .set = into(&Case::readout, &Readout::taxel_circuit)});
}

void add_scan(SchemaRows& rows) {
  rows.push_back({.key = "readout.scan.dwell",
                  .type = ValueType::quantity,
                  .dimension = Dimension::time,
                  .range = {1e-6, 1e7, true, true},
                  .need = Need::where_known,
                  .help = "Reads taxels with circuits of their own one row after another, each for "
                          "so long and from the begin of the run on: the rows of a grid or of a "
                          "crossbar, or the taxels of a list.",
                  .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                    draft.input.readout.scan.dwell = value.numbers[0];
                  }});
  rows.push_back({.key = "readout.scan.others",
                  .type = ValueType::choice,
                  .applies = [](const Case& input) { return input.readout.scan.dwell > 0; },
                  .default_value = "\"grounded\"",
                  .choices = {{"grounded"}, {"open"}},
                  .help = "What a scan does with the taxels of the other rows, or with the other "
                          "rows of a crossbar.",
                  .source = "rows at virtual grounds do not disturb each other",
                  .set =
                      [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                        draft.input.readout.scan.grounds_others = value.text == "grounded";
                      }});
}

void add_instrument(SchemaRows& rows) {
  const auto table = circuits::instruments();
  rows.push_back({.key = "readout.instrument",
                  .type = ValueType::choice,
                  .default_value = fmt::format("\"{}\"", table.front().name),
                  .choices = choices_of(table),
                  .help = fmt::format("What reads the electrodes, for its noise: {}.",
                                      alternatives(table, &circuits::Instrument::meaning)),
                  .source = std::string(table.front().source),
                  .set = into(&Case::readout, &Readout::instrument)});
  const auto noise = [](const std::string& kind, Dimension dimension, double highest,
                        std::optional<double> Readout::*member) {
    return SchemaRow{
        .key = "readout.instrument_" + kind + "_noise",
        .type = ValueType::quantity,
        .dimension = dimension,
        .range = {0, highest, true, true},
        .need = Need::where_known,
        .help = fmt::format("Density of the white {} noise at the input of the instrument, "
                            "one-sided, instead of that of readout.instrument.",
                            kind),
        .set = [member](CaseDraft& draft, const KeyIndex&, const Value& value) {
          draft.input.readout.*member = value.numbers[0];
        }};
  };
  rows.push_back(
      noise("voltage", Dimension::voltage_noise_density, 1, &Readout::instrument_voltage_noise));
  rows.push_back(
      noise("current", Dimension::current_noise_density, 1, &Readout::instrument_current_noise));
  rows.push_back({.key = "readout.instrument_bits",
                  .type = ValueType::integer,
                  .range = {0, 64, true, true},
                  .need = Need::where_known,
                  .help = "Bits of the converter, instead of those of readout.instrument; 0 for "
                          "one that does not round.",
                  .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                    draft.input.readout.instrument_bits = static_cast<int>(value.numbers[0]);
                  }});
}

void add_taxels(SchemaRows& rows) {
  rows.push_back({.key = "readout.taxels[].name",
                  .type = ValueType::text,
                  .need = Need::always,
                  .help =
                      "Name of a taxel, a rectangle of the top electrode with a lead of its own; "
                      "it ends the names of its columns.",
                  .set = into_taxel(&Taxel::name)});
  rows.push_back({.key = "readout.taxels[].lower",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = place_on_skin,
                  .need = Need::always,
                  .help = "Corner of the taxel with the least x and y on the top face.",
                  .set = into_taxel(&Taxel::lower)});
  rows.push_back({.key = "readout.taxels[].upper",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = {1e-9, 10.0, true, true},
                  .need = Need::always,
                  .help = "Corner of the taxel with the greatest x and y on the top face.",
                  .set = into_taxel(&Taxel::upper)});
}

bool is_crossbar(const Case& input) {
  return input.readout.is_crossbar();
}

void add_wiring(SchemaRows& rows) {
  rows.push_back(
      {.key = "readout.taxels.wiring",
       .type = ValueType::choice,
       .need = Need::where_known,
       .choices = {{"single"}, {"crossbar"}},
       .help =
           "Leads of the taxels of a grid: \"single\", one for each, as without this key; or "
           "\"crossbar\", lines that cross: columns of the top electrode, c1, c2, ..., and rows "
           "of the bottom one, r1, r2, ..., each with a potential and a circuit of its own.",
       .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
         draft.input.readout.taxel_grid.wiring =
             value.text == "crossbar" ? TaxelWiring::crossbar : TaxelWiring::single;
       }});
  const auto table = circuits::circuits();
  rows.push_back({.key = "readout.row_circuit",
                  .type = ValueType::choice,
                  .applies = is_crossbar,
                  .default_value = fmt::format("\"{}\"", table.front().name),
                  .choices = choices_of(table),
                  .help = "What joins every row of a crossbar to the ground: a circuit as of "
                          "readout.circuit, with the same keys. That of its columns is "
                          "readout.taxel_circuit, \"short\" unless it is given.",
                  .source = "a row that is read is the ground of its crossings",
                  .set = into(&Case::readout, &Readout::row_circuit)});
}

SchemaRow grid_count(const std::string& name, const std::string& help, int TaxelGrid::*member) {
  return {.key = "readout.taxels." + name,
          .type = ValueType::integer,
          .range = {1, 64, true, true},
          .need = Need::where_known,
          .help = help,
          .set = [member](CaseDraft& draft, const KeyIndex&, const Value& value) {
            draft.input.readout.taxel_grid.*member = static_cast<int>(value.numbers[0]);
          }};
}

void add_taxel_grid(SchemaRows& rows) {
  rows.push_back(grid_count("rows",
                            "Instead of a list of taxels, a grid of equal ones over the whole top "
                            "electrode: so many along y. They are named r1c1, r1c2, ...",
                            &TaxelGrid::rows));
  rows.push_back(grid_count("columns", "So many taxels of a grid along x.", &TaxelGrid::columns));
  rows.push_back(
      {.key = "readout.taxels.gap",
       .type = ValueType::quantity,
       .dimension = Dimension::length,
       .range = place_on_skin,
       .need = Need::where_known,
       .help = "Bare strip between neighbouring taxels of a grid; without it they touch.",
       .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
         draft.input.readout.taxel_grid.gap = value.numbers[0];
       }});
  add_wiring(rows);
}

} // namespace

void add_readout(SchemaRows& rows) {
  rows.push_back({.key = "readout.sample_interval",
                  .type = ValueType::quantity,
                  .dimension = Dimension::time,
                  .range = {1e-9, 1e7, true, true},
                  .default_value = "\"10 ms\"",
                  .help = "Interval of the sampled currents: charge gained over it divided by it.",
                  .source = "100 readings a second, as of an ordinary multimeter interface",
                  .set = into(&Case::readout, &Readout::sample_interval)});
  add_circuit(rows);
  add_instrument(rows);
  add_electrode_contact(rows);
  add_taxel_circuit(rows);
  add_taxels(rows);
  add_circuit_of_taxel(rows);
  add_scan(rows);
  add_taxel_grid(rows);
}

} // namespace ionskin
