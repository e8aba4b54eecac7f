// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

namespace {

void into_layer_material(CaseDraft& draft, const KeyIndex& index, const Value& value) {
  draft.input.skin.layers[index.entry].material.name = value.text;
}

} // namespace

void add_skin(SchemaRows& rows) {
  rows.push_back({.key = "skin.length",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = extent,
                  .need = Need::always,
                  .help = "Length of the skin along x.",
                  .set = into(&Case::skin, &Skin::length)});
  rows.push_back({.key = "skin.width",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = extent,
                  .need = Need::always,
                  .help = "Width of the skin along y.",
                  .set = into(&Case::skin, &Skin::width)});
  rows.push_back({.key = "skin.sides",
                  .type = ValueType::choice,
                  .default_value = "\"free\"",
                  .choices = {{"free"}, {"symmetry"}},
                  .help = "The two faces normal to y: free of traction, or symmetry planes.",
                  .source = "free sides are what a cut strip has",
                  .set = into<Skin, SideCondition>(
                      &Case::skin, &Skin::sides,
                      {{"free", SideCondition::free}, {"symmetry", SideCondition::symmetry}})});
  rows.push_back({.key = "skin.humidity",
                  .type = ValueType::number,
                  .range = {0.0, 1.0, false, true},
                  .need = Need::where_known,
                  .help = "Relative humidity of the air with which the skin is in equilibrium. It "
                          "chooses the constants of materials that give them as lists over "
                          "materials.NAME.humidity.",
                  .set = into(&Case::skin, &Skin::humidity)});
}

void add_layers(SchemaRows& rows) {
  rows.push_back(
      {.key = "skin.layers[].name",
       .type = ValueType::text,
       .need = Need::always,
       .help = "Name of the layer, different from the others; layers stand from bottom to top.",
       .set = into_layer(&Layer::name)});
  rows.push_back(
      {.key = "skin.layers[].role",
       .type = ValueType::choice,
       .need = Need::always,
       .choices = {{"electrode"}, {"core"}},
       .help = "What the layer does: exactly one core conducts ions, between electrodes.",
       .set = into_layer<LayerRole>(
           &Layer::role, {{"electrode", LayerRole::electrode}, {"core", LayerRole::core}})});
  rows.push_back({.key = "skin.layers[].material",
                  .type = ValueType::text,
                  .need = Need::with_contact,
                  .help = "Name of the material: a table of the case, or an installed preset.",
                  .set = into_layer_material});
  rows.push_back({.key = "skin.layers[].thickness",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = film,
                  .need = Need::always,
                  .help = "Thickness of the layer.",
                  .set = into_layer(&Layer::thickness)});
  rows.push_back({.key = "skin.layers[].sheet_resistance",
                  .type = ValueType::quantity,
                  .dimension = Dimension::resistance,
                  .range = {0.0, 1e6, true, true},
                  .need = Need::where_known,
                  .help =
                      "Of an electrode: resistance of a square of its metal along the face. The "
                      "potential then varies along it, from the leads on: readout.contact. "
                      "Without it, or at 0, the metal is at one potential. Of several metals "
                      "on one side of the core those that have one are in parallel.",
                  .set = into_layer(&Layer::sheet_resistance)});
}

void add_materials(SchemaRows& rows) {
  rows.push_back({.key = "materials.NAME.humidity",
                  .type = ValueType::number_list,
                  .range = {0.0, 1.0, true, true},
                  .need = Need::where_known,
                  .help = "Relative humidities, ascending, for which other numbers of the material "
                          "are given as lists of as many entries. Between them they are linear in "
                          "skin.humidity, beyond them it is refused.",
                  .set = [](CaseDraft&, const KeyIndex&, const Value&) {}});
  rows.push_back({.key = "materials.NAME.youngs_modulus",
                  .type = ValueType::quantity,
                  .dimension = Dimension::stress,
                  .range = {1.0, 1e13, true, true},
                  .need = Need::with_contact,
                  .over_humidity = true,
                  .help = "Young's modulus.",
                  .set = into_material(&Material::youngs_modulus)});
  rows.push_back({.key = "materials.NAME.poissons_ratio",
                  .type = ValueType::number,
                  .range = {0.0, 0.49999, true, true},
                  .range_reason = "0.5 is incompressible, which needs a mixed formulation with the "
                                  "pressure as an unknown; 0.4999 works",
                  .need = Need::with_contact,
                  .over_humidity = true,
                  .help = "Poisson's ratio.",
                  .set = into_material(&Material::poissons_ratio)});
  rows.push_back({.key = "materials.NAME.relaxation_times",
                  .type = ValueType::quantity_list,
                  .dimension = Dimension::time,
                  .range = {1e-6, 1e9, true, true},
                  .need = Need::where_known,
                  .help = "Times of the Prony series of the core's shear modulus, ascending, under "
                          "a prescribed pressure or curvature. The elastic constants are those "
                          "of the first instant; the bulk moduli do not relax.",
                  .set = into_material(&Material::relaxation_times)});
  rows.push_back({.key = "materials.NAME.relaxation_shares",
                  .type = ValueType::number_list,
                  .range = {0.0, 1.0, false, false},
                  .need = Need::where_known,
                  .help = "Share of the shear modulus that is gone after each of "
                          "materials.NAME.relaxation_times; together less than 1.",
                  .set = into_material(&Material::relaxation_shares)});
}

} // namespace ionskin
