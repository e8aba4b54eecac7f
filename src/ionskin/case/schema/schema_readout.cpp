// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

namespace {

SchemaRow amplifier_quantity(const std::string& key, Dimension dimension, const Range& range,
                             const std::string& default_value, const std::string& help,
                             const std::string& source, double Amplifier::*member) {
  return {.key = "readout." + key,
          .type = ValueType::quantity,
          .dimension = dimension,
          .range = range,
          .default_value = default_value,
          .help = help,
          .source = source,
          .set = [member](CaseDraft& draft, const KeyIndex&, const Value& value) {
            draft.input.readout.amplifier.*member = value.numbers[0];
          }};
}

void add_circuit(SchemaRows& rows) {
  rows.push_back(
      {.key = "readout.circuit",
       .type = ValueType::choice,
       .default_value = "\"short\"",
       .choices = {{"short"}, {"open"}, {"load"}, {"amplifier"}},
       .help = "What joins the electrodes: a short circuit, nothing, a load resistor, or "
               "a transimpedance amplifier that reads the short-circuit current.",
       .source = "the paper's electrodes are at one potential",
       .set = into<Readout, ReadoutCircuit>(&Case::readout, &Readout::circuit,
                                            {{"short", ReadoutCircuit::short_circuit},
                                             {"open", ReadoutCircuit::open},
                                             {"load", ReadoutCircuit::load},
                                             {"amplifier", ReadoutCircuit::amplifier}})});
  rows.push_back({.key = "readout.load_resistance",
                  .type = ValueType::quantity,
                  .dimension = Dimension::resistance,
                  .range = {1e-3, 1e18, true, true},
                  .default_value = "\"1 MOhm\"",
                  .help = "Resistor between the electrodes in the circuit \"load\".",
                  .source = "input resistance of ordinary oscilloscopes",
                  .set = into(&Case::readout, &Readout::load_resistance)});
}

void add_amplifier(SchemaRows& rows) {
  rows.push_back(amplifier_quantity(
      "amplifier_bandwidth", Dimension::frequency, {1e-6, 1e12, true, true}, "\"1 kHz\"",
      "Bandwidth (-3 dB) of the amplifier's first-order low pass.",
      "an assumption: passes contact events of a millisecond", &Amplifier::bandwidth));
  rows.push_back(amplifier_quantity(
      "amplifier_noise_density", Dimension::current_noise_density, {0.0, 1.0, true, true},
      "\"0 A/sqrt(Hz)\"", "Input-referred white current noise density of the amplifier, one-sided.",
      "an ideal amplifier", &Amplifier::noise_density));
  rows.push_back(amplifier_quantity(
      "amplifier_range", Dimension::current, {0.0, 1e3, true, true}, "\"0 A\"",
      "Largest current that the amplifier can show, of either sign; beyond it clips. 0 A: any.",
      "an ideal amplifier", &Amplifier::range));
  rows.push_back({.key = "readout.noise_seed",
                  .type = ValueType::integer,
                  .range = {0, 2147483647, true, true},
                  .default_value = "1",
                  .help = "Seed of the amplifier's noise: the same seed gives the same noise.",
                  .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                    draft.input.readout.amplifier.noise_seed = static_cast<int>(value.numbers[0]);
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
  add_amplifier(rows);
  add_taxels(rows);
  add_taxel_grid(rows);
}

} // namespace ionskin
