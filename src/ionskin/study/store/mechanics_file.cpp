// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/results_file.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace ionskin::study {

namespace {

/// HDF5 group with one subgroup per coarser solution, each with a path and a strain like those of
/// the run.
constexpr const char* coarser_group = "/companions";
constexpr double most_solves = 1e9;

std::vector<double> onset_column(const SliderRecord& record, std::size_t column) {
  std::vector<double> values;
  for (const auto& onset : record.onsets) {
    values.push_back(onset[column]);
  }
  return values;
}

void write_metrics(results::Hdf5File& file, const std::string& group,
                   const std::vector<readout::Metric>& metrics) {
  std::vector<std::string> names, units;
  std::vector<double> values;
  for (const readout::Metric& metric : metrics) {
    names.push_back(metric.name);
    units.push_back(metric.unit);
    values.push_back(metric.value);
  }
  file.write(group + "/value", values);
  file.write_texts(group + "/name", names);
  file.write_texts(group + "/unit", units);
}

/// Checks that datasets that belong together have one length. Throws UserError.
void require_length(const results::ForeignHdf5File& file, const std::string& dataset,
                    std::size_t actual, std::size_t expected) {
  if (actual != expected) {
    throw UserError(results::read_failure(file.path(), dataset));
  }
}

std::vector<readout::Metric> read_metrics(const results::ForeignHdf5File& file,
                                          const std::string& group) {
  const auto names = file.read_texts(group + "/name");
  const auto units = file.read_texts(group + "/unit");
  const auto values = file.read(group + "/value");
  require_length(file, group + "/unit", units.size(), names.size());
  require_length(file, group + "/value", values.size(), names.size());
  std::vector<readout::Metric> metrics;
  for (std::size_t i = 0; i < names.size(); ++i) {
    metrics.push_back({names[i], values[i], units[i]});
  }
  return metrics;
}

void write_slider_path(results::Hdf5File& file, const std::string& root,
                       const std::vector<double>& time, const SliderRecord& record) {
  file.write_with_unit(root + "/time", time, "s");
  file.write_with_unit(root + "/slider_z", record.slider_z, "m");
  file.write_with_unit(root + "/normal_force", record.normal_force, "N");
  file.write_with_unit(root + "/tangential_force", record.tangential_force, "N");
  file.write_with_unit(root + "/tangential_force_x", record.tangential_force_x, "N");
  file.write_with_unit(root + "/tangential_force_y", record.tangential_force_y, "N");
  file.write_with_unit(root + "/moment_x", record.moment_x, "N m");
  file.write_with_unit(root + "/moment_y", record.moment_y, "N m");
  file.write_with_unit(root + "/moment_z", record.moment_z, "N m");
  file.write_with_unit(root + "/contact_area", record.contact_area, "m2");
  file.write_with_unit(root + "/stick_share", record.stick_share, "1");
  file.write_with_unit(root + "/slip", record.slip, "m");
  if (!record.drive_force_x.empty()) {
    file.write_with_unit(root + "/drive_force_x", record.drive_force_x, "N");
    file.write_with_unit(root + "/drive_force_y", record.drive_force_y, "N");
  }
  file.write_with_unit(root + "/onset_begin", onset_column(record, 0), "s");
  file.write_with_unit(root + "/onset_end", onset_column(record, 1), "s");
  file.write_with_unit(root + "/electrode_stress", record.electrode_stress, "Pa");
  file.write_texts(root + "/warnings", record.warnings);
  write_metrics(file, root + "/metrics", record.metrics);
  write_metrics(file, root + "/cell_errors", record.cell_errors);
  file.set_attribute(root, "join_time", record.join_time);
  file.set_attribute(root, "worst_equilibrium_residual", record.worst_equilibrium_residual);
  file.set_attribute(root, "worst_complementarity_residual", record.worst_complementarity_residual);
  file.set_attribute(root, "contact_solves", record.contact_solves);
  file.set_attribute(root, "sharp_edge", record.sharp_edge ? 1 : 0);
}

/// Writes the record of a run or of a coarser solution, without its strain history, below the group
/// `root`.
void write_path(results::Hdf5File& file, const std::string& root, const MechanicsRecord& record) {
  write_slider_path(file, root, record.history.time, record);
  for (std::size_t i = 0; i < record.further_sliders.size(); ++i) {
    write_slider_path(file, root + readout::slider_suffix(i + 1), record.history.time,
                      record.further_sliders[i]);
  }
}

/// Checks that each dataset of a slider has one entry for every sample of the history. Throws
/// UserError.
void require_samples(const results::ForeignHdf5File& file, const std::string& root,
                     const SliderRecord& record, std::size_t samples) {
  require_length(file, root + "/slider_z", record.slider_z.size(), samples);
  require_length(file, root + "/normal_force", record.normal_force.size(), samples);
  require_length(file, root + "/tangential_force", record.tangential_force.size(), samples);
  require_length(file, root + "/tangential_force_x", record.tangential_force_x.size(), samples);
  require_length(file, root + "/tangential_force_y", record.tangential_force_y.size(), samples);
  require_length(file, root + "/moment_x", record.moment_x.size(), samples);
  require_length(file, root + "/moment_y", record.moment_y.size(), samples);
  require_length(file, root + "/moment_z", record.moment_z.size(), samples);
  require_length(file, root + "/contact_area", record.contact_area.size(), samples);
  require_length(file, root + "/stick_share", record.stick_share.size(), samples);
  require_length(file, root + "/slip", record.slip.size(), samples);
  if (!record.drive_force_x.empty() || !record.drive_force_y.empty()) {
    require_length(file, root + "/drive_force_x", record.drive_force_x.size(), samples);
    require_length(file, root + "/drive_force_y", record.drive_force_y.size(), samples);
  }
}

void require_samples(const results::ForeignHdf5File& file, const std::string& root,
                     const MechanicsRecord& record) {
  const std::size_t samples = record.history.time.size();
  require_samples(file, root, record, samples);
  for (std::size_t i = 0; i < record.further_sliders.size(); ++i) {
    require_samples(file, root + readout::slider_suffix(i + 1), record.further_sliders[i], samples);
  }
}

SliderRecord read_slider_path(const results::ForeignHdf5File& file, const std::string& root) {
  SliderRecord record;
  const auto number = [&](const char* name) {
    return file.number_attribute(root, name).value_or(0);
  };
  record.slider_z = file.read(root + "/slider_z");
  record.normal_force = file.read(root + "/normal_force");
  record.tangential_force = file.read(root + "/tangential_force");
  record.tangential_force_x = file.read(root + "/tangential_force_x");
  record.tangential_force_y = file.read(root + "/tangential_force_y");
  record.moment_x = file.read(root + "/moment_x");
  record.moment_y = file.read(root + "/moment_y");
  record.moment_z = file.read(root + "/moment_z");
  record.contact_area = file.read(root + "/contact_area");
  record.stick_share = file.read(root + "/stick_share");
  record.slip = file.read(root + "/slip");
  if (file.has(root + "/drive_force_x")) {
    record.drive_force_x = file.read(root + "/drive_force_x");
    record.drive_force_y = file.read(root + "/drive_force_y");
  }
  const auto begins = file.read(root + "/onset_begin"), ends = file.read(root + "/onset_end");
  require_length(file, root + "/onset_end", ends.size(), begins.size());
  for (std::size_t i = 0; i < begins.size(); ++i) {
    record.onsets.push_back({begins[i], ends[i]});
  }
  record.metrics = read_metrics(file, root + "/metrics");
  record.cell_errors = read_metrics(file, root + "/cell_errors");
  record.electrode_stress = file.read(root + "/electrode_stress");
  record.warnings = file.read_texts(root + "/warnings");
  record.join_time = number("join_time");
  record.worst_equilibrium_residual = number("worst_equilibrium_residual");
  record.worst_complementarity_residual = number("worst_complementarity_residual");
  record.contact_solves = static_cast<int>(std::clamp(number("contact_solves"), 0.0, most_solves));
  record.sharp_edge = number("sharp_edge") != 0;
  return record;
}

MechanicsRecord read_path(const results::ForeignHdf5File& file, const std::string& root) {
  MechanicsRecord record;
  static_cast<SliderRecord&>(record) = read_slider_path(file, root);
  for (std::size_t i = 1; file.has(root + readout::slider_suffix(i)) && i < most_sliders; ++i) {
    record.further_sliders.push_back(read_slider_path(file, root + readout::slider_suffix(i)));
  }
  return record;
}

} // namespace

void write_mechanics(const std::filesystem::path& path, const std::string& hash,
                     const MechanicsRecord& record, const base::ProgressCallback& progress) {
  const double histories = 1 + static_cast<double>(record.coarser_solutions.size());
  double written = 0;
  results::ResultsFile results(path, results::ResultsFile::Start::empty);
  results.write_strain(record.history);
  results.write_contact(record.maps);
  for (std::size_t i = 0; i < record.further_sliders.size(); ++i) {
    results.write_contact(record.further_sliders[i].maps, readout::slider_suffix(i + 1));
  }
  results::Hdf5File& file = results.file();
  write_path(file, "/path", record);
  file.set_attribute("/path", "mechanics_hash", hash);
  progress("strain history", ++written / histories);
  for (const auto& [name, coarser] : record.coarser_solutions) {
    const std::string group = coarser_group + ("/" + name);
    write_path(file, group + "/path", *coarser);
    results::write_strain(file, group + "/strain", coarser->history);
    progress("strain history", ++written / histories);
  }
  results.commit();
}

std::optional<MechanicsRecord> read_mechanics(const std::filesystem::path& path,
                                              const std::string& hash, const Skin& skin) {
  if (!std::filesystem::exists(path)) {
    return std::nullopt;
  }
  MechanicsRecord record;
  {
    const results::ForeignHdf5File file(path);
    if (!file.has("/path") || file.text_attribute("/path", "mechanics_hash") != hash) {
      return std::nullopt;
    }
    record = read_path(file, "/path");
    record.history = results::read_strain_file(file, skin);
    require_samples(file, "/path", record);
    if (file.has(coarser_group)) {
      for (const std::string& name : file.members(coarser_group)) {
        const std::string group = coarser_group + ("/" + name);
        MechanicsRecord coarser = read_path(file, group + "/path");
        coarser.history = results::read_strain_file(file, skin, group + "/strain");
        require_samples(file, group + "/path", coarser);
        record.coarser_solutions[name] =
            std::make_shared<const MechanicsRecord>(std::move(coarser));
      }
    }
  }
  return record;
}

} // namespace ionskin::study
