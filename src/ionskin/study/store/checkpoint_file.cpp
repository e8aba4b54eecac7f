// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/checkpoint_file.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ionskin::study {
namespace {

using electrochemistry::IonCheckpoint;
using electrochemistry::IonSnapshot;
using electrochemistry::IonSolution;

struct Row {
  const char* name;
  std::vector<double> IonSolution::*values;
};
constexpr std::array rows{Row{"time", &IonSolution::time},
                          Row{"charge_top", &IonSolution::charge_top},
                          Row{"charge_bottom", &IonSolution::charge_bottom},
                          Row{"ramo_charge_top", &IonSolution::ramo_charge_top},
                          Row{"relaxation_charge", &IonSolution::relaxation_charge},
                          Row{"relaxation_current", &IonSolution::relaxation_current},
                          Row{"voltage", &IonSolution::voltage},
                          Row{"metal_drop", &IonSolution::metal_drop},
                          Row{"ion_amount", &IonSolution::ion_amount},
                          Row{"min_concentration", &IonSolution::min_concentration},
                          Row{"max_potential", &IonSolution::max_potential},
                          Row{"shear_integral", &IonSolution::shear_integral},
                          Row{"column_charge_top", &IonSolution::column_charge_top}};

struct WaterRow {
  const char* name;
  std::vector<double> electrochemistry::WaterRows::*values;
};
using electrochemistry::WaterRows;
constexpr std::array water_rows{WaterRow{"pressure_top", &WaterRows::pressure_top},
                                WaterRow{"pressure_bottom", &WaterRows::pressure_bottom},
                                WaterRow{"streaming_voltage", &WaterRows::streaming_voltage},
                                WaterRow{"dilution_voltage", &WaterRows::dilution_voltage},
                                WaterRow{"largest_pressure", &WaterRows::largest_pressure},
                                WaterRow{"largest_drive", &WaterRows::largest_drive},
                                WaterRow{"outflow_top", &WaterRows::outflow_top},
                                WaterRow{"outflow_bottom", &WaterRows::outflow_bottom},
                                WaterRow{"dragged_top", &WaterRows::dragged_top},
                                WaterRow{"dragged_bottom", &WaterRows::dragged_bottom},
                                WaterRow{"dragged_difference", &WaterRows::dragged_difference},
                                WaterRow{"holding_pressure", &WaterRows::holding_pressure}};

struct Counter {
  const char* name;
  std::size_t IonSolution::*value;
};
constexpr std::array counters{
    Counter{"steps", &IonSolution::steps}, Counter{"rejected_steps", &IonSolution::rejected_steps},
    Counter{"residual_evaluations", &IonSolution::residual_evaluations},
    Counter{"krylov_iterations", &IonSolution::krylov_iterations},
    Counter{"preconditioner_setups", &IonSolution::preconditioner_setups}};

/// True if a checkpoint can come from a run: sizes agree, and numbers are finite. Others must not
/// mislead the time integration.
bool is_consistent(const IonCheckpoint& checkpoint) {
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return std::isfinite(value); });
  };
  const electrochemistry::TransportState& state = checkpoint.state;
  const IonSolution& solution = checkpoint.solution;
  if (state.memory &&
      !(std::isfinite(state.memory->time) &&
        state.memory->pressure.pressure.size() == state.memory->pressure.undrained.size() &&
        finite(state.memory->pressure.pressure) && finite(state.memory->pressure.undrained) &&
        finite(state.memory->dragged.pressure) && finite(state.memory->dragged.undrained))) {
    return false;
  }
  return state.next_step > 0 && std::isfinite(state.next_step) &&
         std::isfinite(state.charge_scale) && !state.ions.values.empty() &&
         state.rate.size() == state.ions.values.size() && finite(state.ions.values) &&
         finite(state.rate) && finite(state.electrode_charge) &&
         solution.time.size() == checkpoint.step + 1 && finite(solution.time) &&
         std::is_sorted(solution.time.begin(), solution.time.end());
}

void write_water(results::Hdf5File& file, const poroelasticity::WaterState& water) {
  file.write("/water/pressure", water.pressure.pressure);
  file.write("/water/undrained", water.pressure.undrained);
  file.write("/water/dragged_pressure", water.dragged.pressure);
  file.write("/water/dragged_undrained", water.dragged.undrained);
  file.set_attribute("/water", "time", water.time);
}

poroelasticity::WaterState read_water(const results::ForeignHdf5File& file) {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  return {file.number_attribute("/water", "time").value_or(missing),
          {file.read("/water/pressure"), file.read("/water/undrained")},
          {file.read("/water/dragged_pressure"), file.read("/water/dragged_undrained")}};
}

} // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& input_hash,
                      const IonCheckpoint& checkpoint) {
  base::PendingFile pending(path);
  results::Hdf5File file(pending.path(), results::Hdf5File::Access::create);
  file.set_attribute("/", "input_hash", input_hash);
  file.set_attribute("/", "step", static_cast<double>(checkpoint.step));
  file.write("/state/ions", checkpoint.state.ions.values);
  file.write("/state/rate", checkpoint.state.rate);
  file.write("/state/electrode_charge", checkpoint.state.electrode_charge);
  file.set_attribute("/state", "next_step", checkpoint.state.next_step);
  file.set_attribute("/state", "charge_scale", checkpoint.state.charge_scale);
  if (checkpoint.state.memory) {
    write_water(file, *checkpoint.state.memory);
  }
  const IonSolution& solution = checkpoint.solution;
  file.write("/grid/x", solution.grid.x_edges);
  file.write("/grid/y", solution.grid.y_edges);
  file.write("/grid/z", solution.grid.z_nodes);
  for (const Row& row : rows) {
    file.write(fmt::format("/rows/{}", row.name), solution.*row.values);
  }
  for (const WaterRow& row : water_rows) {
    file.write(fmt::format("/rows/water_{}", row.name), solution.water.*row.values);
  }
  for (const Counter& counter : counters) {
    file.set_attribute("/rows", counter.name, static_cast<double>(solution.*counter.value));
  }
  for (std::size_t i = 0; i < solution.top_segments.size(); ++i) {
    const std::string dataset = fmt::format("/segments/{:06}", i);
    file.write(dataset, solution.top_segments[i].charge);
    file.set_attribute(dataset, "name", solution.top_segments[i].name);
    file.write(fmt::format("/bottom_segments/{:06}", i), solution.top_segments[i].bottom_charge);
    file.write(fmt::format("/segment_voltages/{:06}", i), solution.top_segments[i].voltage);
    file.write(fmt::format("/segment_circuits/{:06}", i), solution.top_segments[i].passed);
    file.write(fmt::format("/segment_others/{:06}", i), solution.top_segments[i].bypassed);
  }
  for (std::size_t i = 0; i < solution.lines.size(); ++i) {
    const std::string dataset = fmt::format("/lines/{:06}", i);
    file.write(dataset, solution.lines[i].charge);
    file.set_attribute(dataset, "name", solution.lines[i].name);
    file.write(fmt::format("/line_voltages/{:06}", i), solution.lines[i].voltage);
    file.write(fmt::format("/line_circuits/{:06}", i), solution.lines[i].passed);
  }
  for (std::size_t i = 0; i < solution.snapshots.size(); ++i) {
    const IonSnapshot& snapshot = solution.snapshots[i];
    const std::string group = fmt::format("/snapshots/{:06}", i);
    file.write(group + "/concentration", snapshot.concentration);
    file.write(group + "/potential", snapshot.potential);
    file.write(group + "/shear", snapshot.shear);
    file.write(group + "/pore_pressure", snapshot.pore_pressure);
    file.write(group + "/swelling", snapshot.swelling);
    file.set_attribute(group, "time", snapshot.time);
  }
  file.close();
  base::seal(pending.path());
  pending.commit();
}

std::optional<IonCheckpoint> read_checkpoint(const std::filesystem::path& path,
                                             const std::string& input_hash) {
  if (base::check_seal(path) != base::SealState::whole) {
    return std::nullopt;
  }
  const results::ForeignHdf5File file(path);
  if (file.text_attribute("/", "input_hash") != input_hash) {
    return std::nullopt;
  }
  IonCheckpoint checkpoint;
  checkpoint.step = static_cast<std::size_t>(file.number_attribute("/", "step").value_or(0));
  checkpoint.state.ions.values = file.read("/state/ions");
  checkpoint.state.rate = file.read("/state/rate");
  const auto read_if_there = [&file](const std::string& dataset) {
    return file.has(dataset) ? file.read(dataset) : std::vector<double>();
  };
  checkpoint.state.electrode_charge = read_if_there("/state/electrode_charge");
  checkpoint.state.next_step = file.number_attribute("/state", "next_step").value_or(0);
  checkpoint.state.charge_scale = file.number_attribute("/state", "charge_scale").value_or(0);
  if (file.has("/water")) {
    checkpoint.state.memory = read_water(file);
  }
  IonSolution& solution = checkpoint.solution;
  solution.grid = {file.read("/grid/x"), file.read("/grid/y"), file.read("/grid/z")};
  for (const Row& row : rows) {
    solution.*row.values = file.read(fmt::format("/rows/{}", row.name));
  }
  for (const WaterRow& row : water_rows) {
    solution.water.*row.values = file.read(fmt::format("/rows/water_{}", row.name));
  }
  for (const Counter& counter : counters) {
    solution.*counter.value =
        static_cast<std::size_t>(file.number_attribute("/rows", counter.name).value_or(0));
  }
  if (file.has("/segments")) {
    for (const std::string& name : file.members("/segments")) {
      const std::string dataset = "/segments/" + name;
      solution.top_segments.push_back(
          {file.text_attribute(dataset, "name").value_or(""), file.read(dataset),
           file.read("/bottom_segments/" + name), read_if_there("/segment_voltages/" + name),
           read_if_there("/segment_circuits/" + name), read_if_there("/segment_others/" + name)});
    }
  }
  if (file.has("/lines")) {
    for (const std::string& name : file.members("/lines")) {
      solution.lines.push_back({file.text_attribute("/lines/" + name, "name").value_or(""),
                                file.read("/lines/" + name),
                                {},
                                file.read("/line_voltages/" + name),
                                file.read("/line_circuits/" + name),
                                {}});
    }
  }
  if (file.has("/snapshots")) {
    for (const std::string& name : file.members("/snapshots")) {
      const std::string group = "/snapshots/" + name;
      solution.snapshots.push_back(
          {file.number_attribute(group, "time").value_or(0), file.read(group + "/concentration"),
           file.read(group + "/potential"), file.read(group + "/shear"),
           file.read(group + "/pore_pressure"), file.read(group + "/swelling")});
    }
  }
  return is_consistent(checkpoint) ? std::optional(std::move(checkpoint)) : std::nullopt;
}

} // namespace ionskin::study
