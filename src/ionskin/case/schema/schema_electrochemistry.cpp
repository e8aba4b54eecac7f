// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/schema/schema_setters.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"

#include <fmt/format.h>

#include <utility>

namespace ionskin {

using units::Dimension;

namespace {

bool is_steric(const Case& input) {
  return input.electrochemistry.ion_model == IonModel::steric;
}

} // namespace

void add_electrochemistry(SchemaRows& rows) {
  rows.push_back({.key = "electrochemistry.temperature",
                  .type = ValueType::quantity,
                  .dimension = Dimension::temperature,
                  .range = {100.0, 1000.0, true, true},
                  .default_value = "\"20 degC\"",
                  .help = "Temperature of the skin.",
                  .source = "room temperature",
                  .set = into(&Case::electrochemistry, &Electrochemistry::temperature)});
  rows.push_back({.key = "electrochemistry.diffusivity",
                  .type = ValueType::quantity,
                  .dimension = Dimension::diffusivity,
                  .range = {1e-18, 1e-4, true, true},
                  .need = Need::always,
                  .of_material = true,
                  .help =
                      "Diffusivity of the mobile cation in the core; where it is not given, the "
                      "one that the material of the core has.",
                  .set = into(&Case::electrochemistry, &Electrochemistry::diffusivity)});
  rows.push_back({.key = "electrochemistry.permittivity",
                  .type = ValueType::quantity,
                  .dimension = Dimension::permittivity,
                  .range = {8e-12, 10.0, true, true},
                  .range_reason = "that of vacuum is 8.85e-12 F/m",
                  .need = Need::always,
                  .help = "Effective permittivity of the core, absolute.",
                  .set = into(&Case::electrochemistry, &Electrochemistry::permittivity)});
  rows.push_back(
      {.key = "electrochemistry.interface_capacitance",
       .type = ValueType::quantity,
       .dimension = Dimension::areal_capacitance,
       .range = {1e-6, 1e6, true, true},
       .need = Need::where_known,
       .of_material = true,
       .help = "Capacitance of one electrode's double layer, per projected area, at small voltage "
               "and low frequency. The true area of rough metal makes it larger than what "
               "electrochemistry.permittivity, then that of the bulk, makes of the projected area; "
               "where it is not given, the two areas are the same.",
       .set = into(&Case::electrochemistry, &Electrochemistry::interface_capacitance)});
  rows.push_back(
      {.key = "electrochemistry.fixed_charge_concentration",
       .type = ValueType::quantity,
       .dimension = Dimension::concentration,
       .range = concentration_range,
       .need = Need::always,
       .of_material = true,
       .help = "Concentration of the fixed anions in the unstrained core; where it is not given, "
               "the one that the material of the core has.",
       .set = into(&Case::electrochemistry, &Electrochemistry::fixed_charge_concentration)});
  rows.push_back({.key = "electrochemistry.valence",
                  .type = ValueType::integer,
                  .range = {1, 4, true, true},
                  .default_value = "1",
                  .of_material = true,
                  .help =
                      "Charge number of the mobile cation; where it is not given, the one that the "
                      "material of the core has.",
                  .source = "alkali cations and protons have 1",
                  .set = into(&Case::electrochemistry, &Electrochemistry::valence)});
  rows.push_back(
      {.key = "electrochemistry.ion_model",
       .type = ValueType::choice,
       .default_value = "\"dilute\"",
       .choices = {{"dilute"}, {"steric"}, {"thin-layers"}},
       .help = "Whether the cations are points, or take room from one another and so stay below "
               "electrochemistry.largest_concentration; or whether their double layers are thin "
               "capacitors on a conductor, which is quick, to first order, and of the law "
               "\"poroelastic\" only.",
       .source = "dilute is the paper's model",
       .set =
           into<Electrochemistry, IonModel>(&Case::electrochemistry, &Electrochemistry::ion_model,
                                            {{"dilute", IonModel::dilute},
                                             {"steric", IonModel::steric},
                                             {"thin-layers", IonModel::thin_layers}})});
  rows.push_back({.key = "electrochemistry.largest_concentration",
                  .type = ValueType::quantity,
                  .dimension = Dimension::concentration,
                  .range = concentration_range,
                  .need = Need::always,
                  .applies = is_steric,
                  .help = "Concentration of the cations when packed as densely as they can be, "
                          "1/(N_A a^3) for a spacing a; of ion_model \"steric\" only.",
                  .set = into(&Case::electrochemistry, &Electrochemistry::largest_concentration)});
}

void add_ions_of_materials(SchemaRows& rows) {
  SchemaRows ions;
  add_electrochemistry(ions);
  add_water(ions);
  for (SchemaRow& row : ions) {
    if (!row.of_material)
      continue;
    const std::string own_key = row.key;
    row.key.replace(0, row.key.find('.'), "materials.NAME");
    row.need = Need::where_known;
    row.purpose = "";
    row.of_material = false;
    row.over_humidity = row.type == ValueType::number || row.type == ValueType::quantity;
    row.default_value = row.source = "";
    row.help = "Of a core made of this material: " + own_key + " where the case does not give it.";
    row.set = [](CaseDraft&, const KeyIndex&, const Value&) {
    }; // `complete_materials` copies the value to its section
    rows.push_back(std::move(row));
  }
}

void add_coupling(SchemaRows& rows) {
  rows.push_back(
      {.key = "coupling.law",
       .type = ValueType::choice,
       .default_value = "\"fixed-charge\"",
       .choices = choices_of(laws::coupling_laws()),
       .help =
           "How shear changes the fixed charge: cf = c0 (1 + k gamma), or with the "
           "mean of gamma over "
           "the core or over the thickness subtracted; or \"poroelastic\": pressure moves water, "
           "which drags the cations, by the constants of [water].",
       .source = "fixed-charge is the paper's law",
       .set = into(&Case::coupling, &Coupling::law)});
  rows.push_back({.key = "coupling.coefficient",
                  .type = ValueType::number,
                  .range = {-1e6, 1e6, true, true},
                  .need = Need::always,
                  .applies = has_coupling_coefficient,
                  .help =
                      "Coefficient k of the coupling law, of either sign. No measurement is known: "
                      "every value is uncalibrated.",
                  .set = into(&Case::coupling, &Coupling::coefficient)});
  const auto measures = laws::shear_measures();
  rows.push_back({.key = "coupling.measure",
                  .type = ValueType::choice,
                  .applies = has_coupling_coefficient,
                  .default_value = fmt::format("\"{}\"", measures.front().name),
                  .choices = choices_of(measures),
                  .help = fmt::format("Scalar gamma made of the strain e: {}.",
                                      alternatives(measures, &laws::ShearMeasure::formula)),
                  .source = "off-diagonal is the paper's equivalent shear strain",
                  .set = into(&Case::coupling, &Coupling::measure)});
  add_law_parameters(rows, LawSection{"coupling", "law", &Case::coupling, &Coupling::law},
                     laws::coupling_laws(), Need::always);
}

} // namespace ionskin
