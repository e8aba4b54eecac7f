// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/waypoint_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/text/csv_table.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace ionskin {

namespace {

using units::Dimension;

const std::map<std::string, Dimension>& known_columns() {
  static const std::map<std::string, Dimension> columns = {
      {"time", Dimension::time},     {"x", Dimension::length},    {"y", Dimension::length},
      {"height", Dimension::length}, {"force", Dimension::force}, {"roll", Dimension::angle},
      {"pitch", Dimension::angle},   {"yaw", Dimension::angle}};
  return columns;
}

constexpr const char* header_example = "time [s], x [mm], y [mm], height [mm]";

/// Reads a waypoint file row by row, and refuses mistakes with their line.
class WaypointReader {
public:
  explicit WaypointReader(const std::string& path) : table_(path, "waypoint") {}

  std::vector<Waypoint> read() {
    read_header();
    std::vector<Waypoint> waypoints;
    while (const auto cells = table_.next()) {
      const Waypoint waypoint = read_row(*cells);
      if (waypoints.empty() || !same(waypoint, waypoints.back()))
        waypoints.push_back(waypoint);
      if (waypoints.size() > most_waypoints)
        table_.refuse(fmt::format("more than {} waypoints", most_waypoints),
                      "leave out those that lie on the way between their neighbours");
    }
    return waypoints;
  }

private:
  struct Column {
    std::string name, unit;
  };

  /// True if two rows are identical: a recorder that pauses may write its last row again.
  static bool same(const Waypoint& a, const Waypoint& b) {
    return a.time == b.time && a.position == b.position && a.height == b.height &&
           a.force == b.force && a.roll == b.roll && a.pitch == b.pitch && a.yaw == b.yaw;
  }

  void read_header() {
    if (table_.titles().empty())
      table_.refuse("the file has no header", fmt::format("begin with \"{}\"", header_example));
    for (const CsvTitle& title : table_.titles()) {
      if (!title.unit)
        table_.refuse(fmt::format("the column \"{}\" has no unit", base::shown(title.name)),
                      fmt::format("write names with units, such as \"{}\"", header_example));
      add_column({title.name, *title.unit});
    }
    for (const char* name : {"time", "x", "y"})
      if (!index_.contains(name))
        table_.refuse(fmt::format("the column \"{}\" is missing", name),
                      fmt::format("the columns are such as \"{}\"", header_example));
    if (!index_.contains("height") && !index_.contains("force"))
      table_.refuse("neither a column \"height\" nor a column \"force\" is there",
                    fmt::format("the columns are such as \"{}\"", header_example));
  }

  void add_column(const Column& column) {
    const auto known = known_columns().find(column.name);
    if (known == known_columns().end()) {
      std::vector<std::string> names;
      for (const auto& [name, dimension] : known_columns())
        names.push_back(name);
      const std::string nearest = base::nearest_name(column.name, names);
      table_.refuse(fmt::format("the column \"{}\" is unknown", base::shown(column.name)),
                    fmt::format("{}; ionskin motion FILE -o path.csv makes a path of a recording",
                                nearest.empty() || column.name.size() < 2
                                    ? "columns: time, x, y, height, force, roll, pitch, yaw"
                                    : fmt::format("did you mean \"{}\"?", nearest)));
    }
    value("1", column.unit, known->second, column.name); // refuses an unknown unit
    if (!index_.emplace(column.name, columns_.size()).second)
      table_.refuse(fmt::format("the column \"{}\" stands twice", column.name), "keep one of them");
    columns_.push_back(column);
  }

  double value(const std::string& number, const std::string& unit, Dimension dimension,
               const std::string& column) const {
    try {
      return units::parse_quantity(number + " " + unit, dimension);
    } catch (const UserError& error) {
      table_.refuse(fmt::format("{}: {}", column, error.what()),
                    fmt::format("{} needs a number, and in the header {}", column,
                                units::dimension_info(dimension).name));
    }
  }

  std::optional<double> entry(const std::vector<std::string>& cells,
                              const std::string& name) const {
    const auto column = index_.find(name);
    if (column == index_.end() || cells[column->second].empty())
      return std::nullopt;
    return value(cells[column->second], columns_[column->second].unit, known_columns().at(name),
                 name);
  }

  double required(const std::vector<std::string>& cells, const std::string& name) const {
    const auto number = entry(cells, name);
    if (!number)
      table_.refuse(fmt::format("{} is empty", name), "every line needs time, x and y");
    return *number;
  }

  Waypoint read_row(const std::vector<std::string>& cells) const {
    const auto height = entry(cells, "height"), force = entry(cells, "force");
    return {required(cells, "time"),
            {required(cells, "x"), required(cells, "y")},
            height,
            force,
            table_.line(),
            entry(cells, "roll"),
            entry(cells, "pitch"),
            entry(cells, "yaw")};
  }

  CsvTable table_;
  std::vector<Column> columns_;
  std::map<std::string, std::size_t> index_;
};

} // namespace

std::vector<Waypoint> read_waypoint_file(const std::string& path) {
  return WaypointReader(path).read();
}

} // namespace ionskin
