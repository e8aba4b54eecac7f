// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema.hpp"

#include "ionskin/case/schema_setters.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin {

namespace {

using units::Dimension;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range positive{0.0, infinity, false, false};
constexpr Range not_negative{0.0, infinity, true, false};

using Rows = std::vector<SchemaRow>;

void into_layer_material(CaseDraft& draft, const KeyIndex& index, const Value& value) {
  draft.input.skin.layers[index.layer].material.name = value.text;
}

// A direction without length stays so, for check_case to refuse.
void into_direction(CaseDraft& draft, const KeyIndex&, const Value& value) {
  const double length = std::hypot(value.numbers[0], value.numbers[1]);
  const double scale = length > 0 ? 1 / length : 1;
  draft.input.motion.direction = {value.numbers[0] * scale, value.numbers[1] * scale};
}

void add_skin(Rows& rows) {
  rows.push_back({.key = "skin.length",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = positive,
                  .need = Need::always,
                  .help = "Length of the skin along x.",
                  .set = into(&Case::skin, &Skin::length)});
  rows.push_back({.key = "skin.width",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = positive,
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
}

void add_layers(Rows& rows) {
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
                  .range = positive,
                  .need = Need::always,
                  .help = "Thickness of the layer.",
                  .set = into_layer(&Layer::thickness)});
}

void add_materials(Rows& rows) {
  rows.push_back({.key = "materials.NAME.youngs_modulus",
                  .type = ValueType::quantity,
                  .dimension = Dimension::stress,
                  .range = positive,
                  .need = Need::with_contact,
                  .help = "Young's modulus.",
                  .set = into_material(&Material::youngs_modulus)});
  rows.push_back({.key = "materials.NAME.poissons_ratio",
                  .type = ValueType::number,
                  .range = {0.0, 0.5, true, false},
                  .range_reason = "0.5 is incompressible, which needs a mixed formulation with the "
                                  "pressure as an unknown; 0.4999 works",
                  .need = Need::with_contact,
                  .help = "Poisson's ratio.",
                  .set = into_material(&Material::poissons_ratio)});
}

void add_slider(Rows& rows) {
  rows.push_back({.key = "slider.shape",
                  .type = ValueType::choice,
                  .default_value = "\"flat\"",
                  .choices = {{"flat"}, {"sphere", false}, {"cylinder", false}, {"profile", false}},
                  .help = "Shape of the underside of the rigid slider; flat has sharp edges.",
                  .source = "the paper's slider is a block",
                  .set = into<Slider, SliderShape>(&Case::slider, &Slider::shape,
                                                   {{"flat", SliderShape::flat}})});
  rows.push_back({.key = "slider.size",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = positive,
                  .need = Need::with_contact,
                  .help = "Footprint of the slider along x and y.",
                  .set = into(&Case::slider, &Slider::size)});
  rows.push_back(
      {.key = "slider.start",
       .type = ValueType::quantity_pair,
       .dimension = Dimension::length,
       .need = Need::with_contact,
       .help = "Centre of the slider at the start of a cycle, x and y from the skin's corner.",
       .set = into(&Case::slider, &Slider::start)});
}

// One duration of the motion.
SchemaRow duration(const std::string& key, const std::string& help, double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::time,
          .range = positive,
          .need = Need::with_contact,
          .help = help,
          .set = into(&Case::motion, member)};
}

// One distance of the motion.
SchemaRow distance(const std::string& key, const std::string& help, const Range& range,
                   double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::length,
          .range = range,
          .need = Need::with_contact,
          .help = help,
          .set = into(&Case::motion, member)};
}

void add_motion(Rows& rows) {
  rows.push_back(
      {.key = "motion.kind",
       .type = ValueType::choice,
       .default_value = "\"touch-slide-lift\"",
       .choices = {{"touch-slide-lift"}},
       .help = "Touchdown, slide in contact, lift-off, detached return.",
       .source = "the paper's cycle",
       .set = into<Motion, MotionKind>(&Case::motion, &Motion::kind,
                                       {{"touch-slide-lift", MotionKind::touch_slide_lift}})});
  rows.push_back(distance("motion.gap",
                          "Clearance between slider and skin at the start of a cycle.",
                          not_negative, &Motion::gap));
  rows.push_back(
      distance("motion.preload", "Indentation while sliding.", positive, &Motion::preload));
  rows.push_back(distance("motion.stroke", "Length of the slide; zero is a press-and-hold.",
                          not_negative, &Motion::stroke));
  rows.push_back({.key = "motion.direction",
                  .type = ValueType::number_pair,
                  .default_value = "[1, 0]",
                  .help = "Direction of the slide in the x-y plane; any length, it is normalised.",
                  .source = "the paper slides along the skin",
                  .set = into_direction});
  rows.push_back(duration("motion.touchdown", "Duration of the descent.", &Motion::touchdown));
  rows.push_back(
      duration("motion.slide", "Duration of the slide, or of the hold.", &Motion::slide));
  rows.push_back(duration("motion.lift", "Duration of the ascent.", &Motion::lift));
  rows.push_back(duration("motion.return", "Duration of the detached return.", &Motion::return_));
  rows.push_back({.key = "motion.cycles",
                  .type = ValueType::integer,
                  .range = {1, 10000, true, true},
                  .default_value = "1",
                  .help = "Number of cycles.",
                  .set = into(&Case::motion, &Motion::cycles)});
}

void add_contact(Rows& rows) {
  rows.push_back({.key = "contact.law",
                  .type = ValueType::choice,
                  .default_value = "\"coulomb\"",
                  .choices = {{"coulomb"}},
                  .help = "Friction law.",
                  .source = "the paper's law",
                  .set = into<Contact, FrictionLaw>(&Case::contact, &Contact::law,
                                                    {{"coulomb", FrictionLaw::coulomb}})});
  rows.push_back(
      {.key = "contact.friction",
       .type = ValueType::number,
       .range = {0, 2, true, true},
       .range_reason = "solutions of Coulomb's law need not be unique at large coefficients",
       .need = Need::with_contact,
       .help = "Coefficient of friction between slider and skin.",
       .set = into(&Case::contact, &Contact::friction)});
}

void add_electrochemistry(Rows& rows) {
  rows.push_back({.key = "electrochemistry.temperature",
                  .type = ValueType::quantity,
                  .dimension = Dimension::temperature,
                  .range = positive,
                  .default_value = "\"20 degC\"",
                  .help = "Temperature of the skin.",
                  .source = "room temperature",
                  .set = into(&Case::electrochemistry, &Electrochemistry::temperature)});
  rows.push_back({.key = "electrochemistry.diffusivity",
                  .type = ValueType::quantity,
                  .dimension = Dimension::diffusivity,
                  .range = positive,
                  .need = Need::always,
                  .help = "Diffusivity of the mobile cation in the core.",
                  .set = into(&Case::electrochemistry, &Electrochemistry::diffusivity)});
  rows.push_back({.key = "electrochemistry.permittivity",
                  .type = ValueType::quantity,
                  .dimension = Dimension::permittivity,
                  .range = positive,
                  .need = Need::always,
                  .help = "Effective permittivity of the core, absolute.",
                  .set = into(&Case::electrochemistry, &Electrochemistry::permittivity)});
  rows.push_back(
      {.key = "electrochemistry.fixed_charge_concentration",
       .type = ValueType::quantity,
       .dimension = Dimension::concentration,
       .range = positive,
       .need = Need::always,
       .help = "Concentration of the fixed anions in the unstrained core.",
       .set = into(&Case::electrochemistry, &Electrochemistry::fixed_charge_concentration)});
  rows.push_back({.key = "electrochemistry.valence",
                  .type = ValueType::integer,
                  .range = {1, 4, true, true},
                  .default_value = "1",
                  .help = "Charge number of the mobile cation.",
                  .source = "alkali cations and protons have 1",
                  .set = into(&Case::electrochemistry, &Electrochemistry::valence)});
}

void add_coupling(Rows& rows) {
  rows.push_back(
      {.key = "coupling.law",
       .type = ValueType::choice,
       .default_value = "\"fixed-charge\"",
       .choices =
           {{"fixed-charge"}, {"volume-neutral"}, {"column-neutral"}, {"pair-generation", false}},
       .help = "How shear changes the fixed charge: cf = c0 (1 + k gamma), or with the "
               "mean of gamma over "
               "the core or over the thickness subtracted.",
       .source = "fixed-charge is the paper's law",
       .set = into<Coupling, CouplingLaw>(&Case::coupling, &Coupling::law,
                                          {{"fixed-charge", CouplingLaw::fixed_charge},
                                           {"volume-neutral", CouplingLaw::volume_neutral},
                                           {"column-neutral", CouplingLaw::column_neutral}})});
  rows.push_back({.key = "coupling.coefficient",
                  .type = ValueType::number,
                  .need = Need::always,
                  .help =
                      "Coefficient k of the coupling law, of either sign. No measurement is known: "
                      "every value is uncalibrated.",
                  .set = into(&Case::coupling, &Coupling::coefficient)});
  rows.push_back(
      {.key = "coupling.measure",
       .type = ValueType::choice,
       .default_value = "\"off-diagonal\"",
       .choices = {{"off-diagonal"}},
       .help = "Scalar made of the strain: gamma = 2 sqrt(exy^2 + eyz^2 + exz^2).",
       .source = "the paper's equivalent shear strain",
       .set = into<Coupling, ShearMeasure>(&Case::coupling, &Coupling::measure,
                                           {{"off-diagonal", ShearMeasure::off_diagonal}})});
}

void add_strain(Rows& rows) {
  rows.push_back({.key = "strain.source",
                  .type = ValueType::choice,
                  .default_value = "\"contact\"",
                  .choices = {{"contact"}, {"file"}},
                  .help = "Where the shear comes from: the contact problem, or a strain file.",
                  .set = into<StrainSource, StrainSourceKind>(
                      &Case::strain, &StrainSource::kind,
                      {{"contact", StrainSourceKind::contact}, {"file", StrainSourceKind::file}})});
  rows.push_back({.key = "strain.file",
                  .type = ValueType::text,
                  .need = Need::with_strain_file,
                  .help = "Strain file (HDF5), relative to the folder of the case file.",
                  .set = into(&Case::strain, &StrainSource::file)});
}

void add_run_control(Rows& rows) {
  rows.push_back({.key = "readout.sample_interval",
                  .type = ValueType::quantity,
                  .dimension = Dimension::time,
                  .range = positive,
                  .default_value = "\"10 ms\"",
                  .help = "Interval of the sampled currents: charge gained over it divided by it.",
                  .source = "100 readings a second, as of an ordinary multimeter interface",
                  .set = into(&Case::readout, &Readout::sample_interval)});
  rows.push_back(
      {.key = "numerics.preset",
       .type = ValueType::choice,
       .default_value = "\"standard\"",
       .choices = {{"coarse"}, {"standard"}, {"fine"}},
       .help = "Accuracy: coarse for a first look, standard for 1 %, fine for 0.25 %.",
       .set = into<Numerics, Preset>(
           &Case::numerics, &Numerics::preset,
           {{"coarse", Preset::coarse}, {"standard", Preset::standard}, {"fine", Preset::fine}})});
  rows.push_back({.key = "numerics.mesh_refinement",
                  .type = ValueType::number,
                  .range = {0.1, 10, true, true},
                  .default_value = "1",
                  .help = "Divides every mesh size of the preset; for convergence studies.",
                  .set = into(&Case::numerics, &Numerics::mesh_refinement)});
  rows.push_back({.key = "numerics.time_refinement",
                  .type = ValueType::number,
                  .range = {0.1, 100, true, true},
                  .default_value = "1",
                  .help = "Divides every time step of the preset; for convergence studies.",
                  .set = into(&Case::numerics, &Numerics::time_refinement)});
  rows.push_back({.key = "output.fields",
                  .type = ValueType::quantity_list,
                  .dimension = Dimension::time,
                  .range = not_negative,
                  .default_value = "[]",
                  .help = "Instants at which fields are written.",
                  .set = into(&Case::output, &Output::fields)});
}

} // namespace

bool Range::contains(double value) const {
  const bool above = lower_included ? value >= lower : value > lower;
  const bool below = upper_included ? value <= upper : value < upper;
  return above && below;
}

std::string describe(const Range& range, Dimension dimension) {
  const std::string lower = units::format_si(range.lower, dimension);
  const std::string upper = units::format_si(range.upper, dimension);
  const std::string from = fmt::format("{} {}", range.lower_included ? "at least" : "above", lower);
  const std::string to = fmt::format("{} {}", range.upper_included ? "at most" : "below", upper);
  if (std::isinf(range.lower))
    return std::isinf(range.upper) ? "any finite value" : to;
  return std::isinf(range.upper) ? from : from + " and " + to;
}

const std::vector<SchemaRow>& schema() {
  static const Rows rows = [] {
    Rows all;
    all.push_back({.key = "title",
                   .type = ValueType::text,
                   .default_value = "\"\"",
                   .help = "Title of the run, for the report.",
                   .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                     draft.input.title = value.text;
                   }});
    for (const auto add : {add_skin, add_layers, add_materials, add_slider, add_motion, add_contact,
                           add_electrochemistry, add_coupling, add_strain, add_run_control})
      add(all);
    return all;
  }();
  return rows;
}

const SchemaRow* find_row(const std::string& pattern) {
  const auto found = std::find_if(schema().begin(), schema().end(),
                                  [&](const SchemaRow& row) { return row.key == pattern; });
  return found == schema().end() ? nullptr : &*found;
}

const std::map<std::string, std::string>& keys_of_later_versions() {
  static const std::map<std::string, std::string> keys = {
      {"slider.edge_radius", "rounded edges"},
      {"slider.radius", "spherical and cylindrical sliders"},
      {"slider.profile", "sliders of any profile"},
  };
  return keys;
}

} // namespace ionskin
