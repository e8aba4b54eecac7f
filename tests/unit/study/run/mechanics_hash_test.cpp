// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/study/run/run_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace ionskin::study {
namespace {

// Every key of the schema stands in one of these: a new one is put where it belongs.
const std::set<std::string> decides_study_one{
    "skin.length",
    "skin.width",
    "skin.sides",
    "skin.layers[].role",
    "skin.layers[].thickness",
    "materials.NAME.youngs_modulus",
    "materials.NAME.poissons_ratio",
    "slider.shape",
    "slider.size",
    "slider.edge_radius",
    "slider.radius",
    "slider.start",
    "slider.roll",
    "slider.pitch",
    "slider.yaw",
    "slider.youngs_modulus",
    "slider.poissons_ratio",
    "slider.pad_thickness",
    "motion.kind",
    "motion.gap",
    "motion.preload",
    "motion.stroke",
    "motion.direction",
    "motion.touchdown",
    "motion.slide",
    "motion.lift",
    "motion.return",
    "motion.strokes",
    "motion.dwell",
    "motion.cycles",
    "motion.drive.stiffness",
    "motion.drive.damping",
    "motion.drive.mass",
    "motion.waypoints[].time",
    "motion.waypoints[].position",
    "motion.waypoints[].height",
    "motion.waypoints[].force",
    "motion.waypoints[].roll",
    "motion.waypoints[].pitch",
    "motion.waypoints[].yaw",
    "contact.law",
    "contact.friction",
    "coupling.law", // one that moves water has channels and a grid of its own
    "coupling.measure",
    "numerics.preset",
    "numerics.mesh_refinement",
    "numerics.time_refinement",
    "numerics.error_estimate",
    "output.fields"}; // samples of the history
const std::set<std::string> leaves_study_one{
    "title",
    "skin.layers[].name",
    "skin.layers[].material", // by what it is made of
    "skin.layers[].sheet_resistance",
    "skin.humidity", // by the numbers that it chooses
    "materials.NAME.humidity",
    "materials.NAME.relaxation_times", // of a prescribed load only
    "materials.NAME.relaxation_shares",
    "materials.NAME.diffusivity",
    "materials.NAME.fixed_charge_concentration",
    "materials.NAME.valence",
    "materials.NAME.drag_number",
    "materials.NAME.volume_fraction",
    "materials.NAME.mobility",
    "slider.profile", // by the heights, below
    "motion.file",    // by the waypoints
    "electrochemistry.temperature",
    "electrochemistry.diffusivity",
    "electrochemistry.permittivity",
    "electrochemistry.interface_capacitance",
    "materials.NAME.interface_capacitance",
    "electrochemistry.fixed_charge_concentration",
    "electrochemistry.valence",
    "electrochemistry.ion_model",
    "electrochemistry.largest_concentration",
    "coupling.coefficient",
    "water.drag_number",
    "water.drained_poissons_ratio",
    "water.drained_modulus",
    "water.permeability",
    "water.viscosity",
    "water.mobility",
    "water.consolidation_coefficient",
    "water.dilution",
    "water.volume_fraction",
    "water.bottom_wall",
    "water.top_wall",
    "water.bottom_conductance",
    "water.bottom_pressure",
    "water.top_conductance",
    "water.top_pressure",
    "strain.source", // of a file there is no Study 1
    "strain.file",
    "strain.pressure", // nor of a prescribed load
    "strain.compression",
    "strain.curvature",
    "strain.waveform",
    "strain.rise",
    "strain.frequency",
    "strain.duration",
    "readout.sample_interval",
    "readout.instrument",
    "readout.instrument_voltage_noise",
    "readout.instrument_current_noise",
    "readout.instrument_bits",
    "readout.circuit",
    "readout.contact",
    "readout.taxel_circuit",
    "readout.taxels[].name",
    "readout.taxels[].lower",
    "readout.taxels[].upper",
    "readout.taxels[].circuit",
    "readout.scan.dwell",
    "readout.scan.others",
    "readout.taxels.rows",
    "readout.taxels.columns",
    "readout.taxels.gap",
    "readout.taxels.wiring",
    "readout.row_circuit",
    "numerics.shared_positions.from", // of older versions
    "numerics.shared_positions.to",
    "numerics.shared_positions.footprint",
    "numerics.time_tolerance"};

/// Circuits and laws declare their keys themselves: whether one of the rows has that of a section.
bool belongs_to(const auto& rows, const std::string& section, const std::string& key) {
  return std::ranges::any_of(rows, [&](const auto& row) {
    return std::ranges::any_of(row.parameters, [&](const laws::LawParameter& parameter) {
      return key == section + "." + std::string(parameter.name);
    });
  });
}

std::vector<Value> values_of(const SchemaRow& row) {
  std::vector<Value> values;
  if (row.type == ValueType::choice && row.choices.size() > 1) {
    for (const Choice& choice : row.choices) {
      if (choice.in_this_version) {
        values.push_back({choice.name, {}});
      }
    }
    return values;
  }
  for (const double number : {1.0, 2.0}) {
    values.push_back({"text " + std::to_string(number), {number, 3}, row.dimension});
    if (row.other_dimension) {
      values.push_back({"", {number, 3}, *row.other_dimension});
    }
  }
  return values;
}

std::string hash_with(const SchemaRow& row, const Value& value) {
  CaseDraft draft;
  draft.input.skin.layers.resize(1);
  draft.input.readout.taxels.resize(1);
  draft.input.motion.waypoints.resize(1);
  row.set(draft, {0, "metal"}, value);
  const std::string name = draft.input.skin.layers[0].material.name;
  draft.input.skin.layers[0].material = draft.materials["metal"];
  draft.input.skin.layers[0].material.name = name;
  return mechanics_hash(draft.input);
}

TEST(MechanicsHash, KnowsTheKeysThatDecideStudyOneAndNoOthers) {
  for (const SchemaRow& row : schema()) {
    const bool decides = decides_study_one.contains(row.key) ||
                         belongs_to(laws::friction_laws(), "contact", row.key);
    ASSERT_NE(decides, leaves_study_one.contains(row.key) ||
                           belongs_to(circuits::circuits(), "readout", row.key) ||
                           belongs_to(circuits::circuits(), "readout.taxels[]", row.key))
        << row.key << " stands in neither list";
    std::set<std::string> hashes;
    const std::vector<Value> values = values_of(row);
    for (const Value& value : values) {
      hashes.insert(hash_with(row, value));
    }
    if (!decides) {
      EXPECT_EQ(hashes.size(), 1u) << row.key;
    } else if (row.key == "coupling.law") {
      EXPECT_EQ(hashes.size(), 2u) << "laws with and without water";
    } else {
      EXPECT_EQ(hashes.size(), values.size()) << row.key;
    }
  }
}

TEST(MechanicsHash, KnowsWhatStandsInFiles) {
  Case input, other;
  other.slider.profile_heights = {{0, 1}, {0, 1}, {0, 0, 0, 1e-6}};
  EXPECT_NE(mechanics_hash(input), mechanics_hash(other));
  other = input;
  other.motion.waypoints = {{1, {2, 3}, 4, {}}};
  EXPECT_NE(mechanics_hash(input), mechanics_hash(other));
}

TEST(MechanicsHash, KnowsEverySlider) {
  Case input;
  const std::string alone = mechanics_hash(input);
  input.further_sliders.emplace_back();
  const std::string two = mechanics_hash(input);
  EXPECT_NE(two, alone);
  input.further_sliders[0].contact.friction = 0.4;
  const std::string rough = mechanics_hash(input);
  EXPECT_NE(rough, two);
  input.further_sliders[0].motion.stroke = 1e-3;
  EXPECT_NE(mechanics_hash(input), rough);
}

} // namespace
} // namespace ionskin::study
