// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/strain_file/strain_file.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <cstddef>
#include <map>

namespace ionskin::results {
namespace {

void write_fields(Hdf5File& file, const std::string& dataset, const history::CoreHistory& history,
                  const history::HistoryChannel& channel) {
  const history::StrainGrid& grid = history.grid;
  file.create_frames(
      dataset, {history.time.size(), grid.z_nodes.size(), grid.columns_y(), grid.columns_x()});
  std::map<const history::StrainField*, std::size_t> written;
  for (std::size_t i = 0; i < channel.samples.size(); ++i) {
    const auto [first, is_new] = written.emplace(channel.samples[i].get(), i);
    if (is_new) {
      file.write_frame(dataset, i, *channel.samples[i]);
    } else {
      file.repeat_frame(dataset, first->second, i);
    }
  }
  file.set_attribute(dataset, "unit", channel.unit);
}

} // namespace

void write_strain(Hdf5File& file, const std::string& group, const history::CoreHistory& history) {
  const std::string root = group == "/" ? "" : group;
  file.write_with_unit(root + "/grid/x", history.grid.x_edges, "m");
  file.write_with_unit(root + "/grid/y", history.grid.y_edges, "m");
  file.write_with_unit(root + "/grid/z", history.grid.z_nodes, "m");
  file.write_with_unit(root + "/time", history.time, "s");
  if (!history.event_time.empty()) {
    file.write_with_unit(root + "/event_time", history.event_time, "s");
  }
  const bool rides = history.frame == history::Frame::slider;
  if (rides) {
    file.write_with_unit(root + "/slider_x", history.slider_x, "m");
  }
  if (rides && !history.slider_y.empty()) {
    file.write_with_unit(root + "/slider_y", history.slider_y, "m");
  }
  const bool shear_alone =
      history.channels.size() == 1 && history.find(history::channel_name::shear) != nullptr;
  for (const history::HistoryChannel& channel : history.channels) {
    const std::string dataset = root + (shear_alone ? "/gamma" : "/channels/" + channel.name);
    write_fields(file, dataset, history, channel);
    if (!shear_alone && channel.name == history::channel_name::shear) {
      file.link(dataset, root + "/gamma"); // name under which readers of version 1 look
    }
  }
  file.set_attribute(group, "format", std::string("ionskin-strain"));
  file.set_attribute(group, "version", shear_alone ? 1 : 2);
  file.set_attribute(group, "measure", history.measure);
  file.set_attribute(group, "frame", std::string(rides ? "slider" : "skin"));
}

void write_strain_file(const std::filesystem::path& path, const history::CoreHistory& history) {
  base::PendingFile pending(path);
  Hdf5File file(pending.path(), Hdf5File::Access::create);
  write_strain(file, "/", history);
  file.close();
  pending.commit();
}

} // namespace ionskin::results
