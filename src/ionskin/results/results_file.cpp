// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/results_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/slider_surface.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace ionskin::results {
namespace {

Hdf5File::Access prepare(const std::filesystem::path& path, const std::filesystem::path& pending,
                         ResultsFile::Start start) {
  std::error_code error;
  if (start == ResultsFile::Start::empty || !std::filesystem::exists(path, error)) {
    return Hdf5File::Access::create;
  }
  // The HDF5 library opens the copy in this process, so a damaged file must be found before.
  ForeignHdf5File(path).require_plain();
  std::filesystem::copy_file(path, pending, std::filesystem::copy_options::overwrite_existing,
                             error);
  if (error) {
    throw UserError(write_failure(pending, "a copy of " + path.string()));
  }
  return Hdf5File::Access::modify;
}

void write_field(Hdf5File& file, const std::string& dataset, const std::vector<double>& values,
                 const std::string& unit, const Hdf5File::Shape& shape) {
  file.create_frames(dataset, {1, shape[0], shape[1], shape[2]});
  file.write_frame(dataset, 0, values);
  file.set_attribute(dataset, "unit", unit);
}

} // namespace

ResultsFile::ResultsFile(const std::filesystem::path& path, Start start)
    : pending_(path), file_(pending_.path(), prepare(path, pending_.path(), start)) {}

void ResultsFile::write_signals(const std::string& group, const readout::SignalTable& table) {
  file_.remove("/" + group);
  for (const readout::Signal& signal : table.columns) {
    file_.write_with_unit("/" + group + "/" + signal.name, signal.values, signal.unit);
  }
  if (!table.cycle.empty()) {
    file_.write("/" + group + "/cycle", table.cycle);
    file_.write_texts("/" + group + "/phase", table.phase);
  }
}

void ResultsFile::write_strain(const history::CoreHistory& history) {
  file_.remove("/strain");
  results::write_strain(file_, "/strain", history);
}

void ResultsFile::write_ions(const electrochemistry::TransportGrid& grid,
                             const std::vector<electrochemistry::IonSnapshot>& snapshots) {
  file_.remove("/ions");
  file_.write_with_unit("/ions/grid/x", grid.x_edges, "m");
  file_.write_with_unit("/ions/grid/y", grid.y_edges, "m");
  file_.write_with_unit("/ions/grid/z", grid.z_nodes, "m");
  const Hdf5File::Shape shape{grid.z_nodes.size(), grid.y_edges.size() - 1,
                              grid.x_edges.size() - 1};
  for (const electrochemistry::IonSnapshot& snapshot : snapshots) {
    const std::string group = fmt::format("/ions/{}", snapshot.time);
    write_field(file_, group + "/concentration", snapshot.concentration, "mol/m3", shape);
    write_field(file_, group + "/potential", snapshot.potential, "V", shape);
    write_field(file_, group + "/shear", snapshot.shear, "1", shape);
    if (!snapshot.pore_pressure.empty()) {
      write_field(file_, group + "/pore_pressure", snapshot.pore_pressure, "Pa", shape);
      write_field(file_, group + "/swelling", snapshot.swelling, "1", shape);
    }
    file_.set_attribute(group, "time", snapshot.time);
  }
}

void ResultsFile::write_contact(const ContactMaps& contact, const std::string& suffix) {
  const std::string root = "/contact" + suffix;
  file_.remove(root);
  file_.write_with_unit(root + "/grid/x", contact.cell_lines_x, "m");
  file_.write_with_unit(root + "/grid/y", contact.cell_lines_y, "m");
  const Hdf5File::Shape shape{contact.cell_lines_y.size() - 1, contact.cell_lines_x.size() - 1};
  for (const ContactMap& map : contact.maps) {
    const std::string group = root + "/" + map.state;
    file_.write_with_unit(group + "/pressure", map.pressure, "Pa", shape);
    file_.write_with_unit(group + "/shear_x", map.shear_x, "Pa", shape);
    file_.write_with_unit(group + "/shear_y", map.shear_y, "Pa", shape);
    file_.write_with_unit(group + "/slip", map.slip, "m", shape);
    file_.write_with_unit(group + "/slip_state", map.slip_state, "1", shape);
    file_.write_with_unit(group + "/slip_since_landing", map.slip_since_landing, "m", shape);
    file_.set_attribute(group, "parameter", map.time);
  }
}

void ResultsFile::write_slider(const Slider& slider, const std::string& suffix) {
  const std::string root = "/slider" + suffix;
  file_.remove(root);
  const SliderSurface surface = slider_surface(slider);
  file_.write_with_unit(root + "/x", surface.x, "m");
  file_.write_with_unit(root + "/y", surface.y, "m");
  file_.write_with_unit(root + "/height", surface.height, "m",
                        {surface.y.size(), surface.x.size()});
}

void ResultsFile::write_text(const std::string& name, const std::string& text) {
  file_.remove("/" + name);
  file_.write_text("/" + name, text);
}

void ResultsFile::commit() {
  file_.close();
  base::seal(pending_.path());
  pending_.commit();
}

} // namespace ionskin::results
