// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/available_memory.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/results/strain_file/strain_events.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"
#include "ionskin/results/strain_file/strain_file_checks.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace ionskin::results {
namespace {

constexpr const char* format_name = "ionskin-strain";
/// Share of the available memory that the strain history may take, since ion transport takes more
/// [1].
constexpr double free_share = 0.5;

// Pool that returns one shared field for all identical fields.
class FieldPool {
public:
  std::shared_ptr<const history::StrainField> share(history::StrainField field) {
    const std::string_view bytes(reinterpret_cast<const char*>(field.data()),
                                 field.size() * sizeof(double));
    const std::size_t hash = std::hash<std::string_view>{}(bytes);
    const auto [begin, end] = fields_.equal_range(hash);
    for (auto candidate = begin; candidate != end; ++candidate) {
      if (*candidate->second == field) {
        return candidate->second;
      }
    }
    auto shared = std::make_shared<const history::StrainField>(std::move(field));
    fields_.emplace(hash, shared);
    return shared;
  }

  std::size_t distinct() const { return fields_.size(); }

private:
  std::unordered_multimap<std::size_t, std::shared_ptr<const history::StrainField>> fields_;
};

class StrainFileReader {
public:
  StrainFileReader(const ForeignHdf5File& file, const std::string& group)
      : file_(file), checks_(file.path().string()), group_(group.empty() ? find_group() : group) {}

  history::CoreHistory read(const Skin& skin) {
    history::CoreHistory history;
    read_attributes(history);
    read_grid(history);
    history.length = skin.length;
    history.width = skin.width;
    read_slider(history);
    checks_.covers_core(history, skin);
    // Rounding in the file must not leave a thin layer of the core outside the grid.
    history.grid.z_nodes.front() = 0;
    history.grid.z_nodes.back() = skin.core_thickness();
    read_fields(history);
    read_events(history);
    return history;
  }

private:
  std::string object(const std::string& name) const { return group_ + "/" + name; }
  std::string root() const { return group_.empty() ? "/" : group_; }

  // Group that holds the strain: /strain of a results.h5, or empty for the root of a strain file.
  std::string find_group() const {
    const bool in_results =
        file_.has("/strain") && file_.text_attribute("/strain", "format") == format_name;
    return in_results ? "/strain" : "";
  }

  std::string required_text(const std::string& name, const std::string& example) const {
    const std::optional<std::string> text = file_.text_attribute(root(), name);
    if (!text) {
      checks_.fail(fmt::format("the text attribute {} is missing", name),
                   fmt::format("set it, in h5py: file.attrs[\"{}\"] = \"{}\"", name, example));
    }
    return *text;
  }

  void read_attributes(history::CoreHistory& history) const {
    const std::string format = required_text("format", format_name);
    if (format != format_name) {
      checks_.fail(fmt::format("its attribute format is \"{}\", not \"{}\"", format, format_name),
                   "name a strain file, or the results.h5 of a run");
    }
    const std::optional<double> version = file_.number_attribute(root(), "version");
    if (version != 1 && version != 2) {
      checks_.fail(version ? fmt::format("its version is {}", *version)
                           : "the number attribute version is missing",
                   "this program reads versions 1 and 2");
    }
    history.measure = required_text("measure", "off-diagonal");
    const std::string frame = required_text("frame", "skin");
    if (frame != "skin" && frame != "slider") {
      checks_.fail(fmt::format("its attribute frame is \"{}\"", frame),
                   "write \"skin\", or \"slider\" with slider_x");
    }
    history.frame = frame == "slider" ? history::Frame::slider : history::Frame::skin;
  }

  void require_dataset(const std::string& name) const {
    if (!file_.has(object(name))) {
      checks_.fail(fmt::format("the dataset {} is missing", object(name)),
                   "write grid/x, grid/y, grid/z, time and gamma");
    }
    if (!file_.has_numbers(object(name))) {
      checks_.fail(fmt::format("{} is not a dataset of numbers", object(name)),
                   "write floating-point numbers");
    }
  }

  void check_unit(const std::string& name, const std::string& expected, bool required) const {
    const std::optional<std::string> unit = file_.text_attribute(object(name), "unit");
    if (!unit && required) {
      checks_.fail(
          fmt::format("{} has no attribute unit", name),
          fmt::format("set it, in h5py: file[\"{}\"].attrs[\"unit\"] = \"{}\"", name, expected));
    }
    if (unit && *unit != expected) {
      checks_.fail(fmt::format("{} has the unit \"{}\"", name, *unit),
                   fmt::format("write it in the unit \"{}\"", expected));
    }
  }

  std::vector<double> read_line(const std::string& name, const std::string& unit) const {
    require_dataset(name);
    const std::size_t dimensions = file_.shape(object(name)).size();
    if (dimensions != 1) {
      checks_.fail(fmt::format("{} has {} dimensions", name, dimensions), "write it with one");
    }
    check_unit(name, unit, false);
    return file_.read(object(name));
  }

  void read_grid(history::CoreHistory& history) const {
    history.grid.x_edges = read_line("grid/x", "m");
    history.grid.y_edges = read_line("grid/y", "m");
    history.grid.z_nodes = read_line("grid/z", "m");
    history.time = read_line("time", "s");
    checks_.ascending("grid/x", history.grid.x_edges);
    checks_.ascending("grid/y", history.grid.y_edges);
    checks_.ascending("grid/z", history.grid.z_nodes);
    checks_.ascending("time", history.time);
    checks_.sane_lengths("grid/x", history.grid.x_edges);
    checks_.sane_lengths("grid/y", history.grid.y_edges);
    checks_.sane_lengths("grid/z", history.grid.z_nodes);
    checks_.sane_times(history.time);
  }

  std::vector<double> read_positions(const std::string& name, std::size_t samples) const {
    std::vector<double> positions = read_line(name, "m");
    checks_.same_length(name, positions.size(), samples);
    checks_.finite(name, positions);
    checks_.sane_positions(name, positions);
    return positions;
  }

  void read_slider(history::CoreHistory& history) const {
    if (history.frame == history::Frame::skin) {
      return;
    }
    history.slider_x = read_positions("slider_x", history.time.size());
    if (file_.has(object("slider_y"))) {
      history.slider_y = read_positions("slider_y", history.time.size());
    }
  }

  /// Reads the strain channels: only the shear in version 1, channels by name in version 2.
  void read_fields(history::CoreHistory& history) const {
    if (!file_.has(object("channels"))) {
      read_channel(history, "gamma", history::channel_name::shear, "1");
      return;
    }
    for (const std::string& name : file_.members(object("channels"))) {
      const std::string* unit = history::unit_of_channel(name);
      if (unit == nullptr) {
        checks_.fail(fmt::format("channels/{} is not a channel that this program knows", name),
                     fmt::format("known: {}", history::known_channels()));
      }
      read_channel(history, "channels/" + name, name, *unit);
    }
    if (history.channels.empty()) {
      checks_.fail("the group channels is empty",
                   fmt::format("write one of {}", history::known_channels()));
    }
  }

  void read_channel(history::CoreHistory& history, const std::string& dataset,
                    const std::string& name, const std::string& unit) const {
    require_dataset(dataset);
    check_unit(dataset, unit, true);
    checks_.shape(dataset, history.grid, history.time.size(), file_.shape(object(dataset)));
    history::HistoryChannel& channel = history.add_channel(name, unit);
    FieldPool pool;
    const double free = free_share * base::available_memory().bytes;
    for (std::size_t sample = 0; sample < history.time.size(); ++sample) {
      history::StrainField field;
      file_.read_frame(object(dataset), sample, field);
      checks_.finite_field(dataset, history, sample, field, history::largest_of_channel(name));
      channel.samples.push_back(pool.share(std::move(field)));
      const double bytes =
          static_cast<double>(pool.distinct() * history.grid.values() * sizeof(double));
      if (bytes > free) {
        checks_.fail(fmt::format("the first {} of {} samples of {} take {:.3g} GB of memory, and "
                                 "{:.3g} GB were free for it",
                                 sample + 1, history.time.size(), dataset, bytes * 1e-9,
                                 free * 1e-9),
                     "write fewer samples or a coarser grid, or free memory");
      }
    }
  }

  void read_events(history::CoreHistory& history) const {
    if (!file_.has(object("event_time"))) {
      history.event_time = detect_events(history);
      return;
    }
    history.event_time = read_line("event_time", "s");
    checks_.finite("event_time", history.event_time);
    checks_.events_are_samples(history);
  }

  const ForeignHdf5File& file_;
  StrainFileChecks checks_;
  std::string group_;
};

} // namespace

history::CoreHistory read_strain_file(const std::filesystem::path& path, const Skin& skin,
                                      const std::string& group) {
  return read_strain_file(ForeignHdf5File(path), skin, group);
}

history::CoreHistory read_strain_file(const ForeignHdf5File& file, const Skin& skin,
                                      const std::string& group) {
  return StrainFileReader(file, group).read(skin);
}

} // namespace ionskin::results
