// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/case/schema/schema_setters.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/circuits/instruments.hpp"

#include <fmt/format.h>

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
  add_taxels(rows);
  add_taxel_grid(rows);
}

} // namespace ionskin
