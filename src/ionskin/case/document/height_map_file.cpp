// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/height_map_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/text/csv_file.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace ionskin {

namespace {

constexpr std::size_t most_heights = 4'000'000;
constexpr double largest_length = 10; // [m]

class TableReader {
public:
  explicit TableReader(const std::string& path) : path_(path), file_(path, "height map") {}

  shapes::HeightMap read() {
    shapes::HeightMap map;
    std::string unit;
    while (std::optional<std::vector<std::string>> row = file_.next()) {
      std::vector<std::string>& fields = *row;
      while (fields.back().empty()) // ignore separators at the end of a line
        fields.pop_back();
      if (unit.empty()) {
        unit = fields.front();
        for (std::size_t i = 1; i < fields.size(); ++i)
          append_line(map.x, length(fields[i], unit), "x");
        if (map.x.size() < 2)
          refuse("the first row needs a unit of length and at least two values of x");
        continue;
      }
      if (map.height.size() + fields.size() > most_heights)
        refuse(fmt::format("more than {} heights", most_heights));
      if (fields.size() != map.x.size() + 1)
        refuse(fmt::format("{} values instead of y and {} heights", fields.size(), map.x.size()));
      append_line(map.y, length(fields.front(), unit), "y");
      for (std::size_t i = 1; i < fields.size(); ++i)
        map.height.push_back(length(fields[i], unit));
    }
    if (map.y.size() < 2)
      refuse("at least two rows of heights are needed");
    return map;
  }

private:
  double length(const std::string& number, const std::string& unit) const {
    double value = 0;
    try {
      value = units::parse_quantity(number + " " + unit, units::Dimension::length);
    } catch (const UserError& error) {
      refuse(error.what());
    }
    if (std::abs(value) > largest_length)
      refuse(fmt::format("{} {} is more than {} m", base::shown(number), base::shown(unit),
                         largest_length));
    return value;
  }

  void append_line(std::vector<double>& lines, double value, const char* axis) const {
    if (!lines.empty() && value <= lines.back())
      refuse(fmt::format("the values of {} must ascend", axis));
    lines.push_back(value);
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw UserError(fmt::format("the height map {} cannot be used: {}\n  in its line {}\n  = "
                                "first row: unit of length, values of x; then rows of y and "
                                "the heights there, separated by commas",
                                base::shown(path_), message, file_.line()));
  }

  const std::string& path_;
  CsvFile file_;
};

} // namespace

shapes::HeightMap read_height_map(const std::string& path) {
  return TableReader(path).read();
}

} // namespace ionskin
