// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/height_map.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/text/csv_file.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace ionskin {

namespace {

constexpr std::size_t most_heights = 4'000'000;
constexpr double largest_length = 10; // [m]

class TableReader {
public:
  explicit TableReader(const std::string& path) : path_(path), file_(path, "height map") {}

  HeightMap read() {
    HeightMap map;
    std::string unit;
    while (std::optional<CsvRow> row = file_.next()) {
      std::vector<std::string>& fields = row->cells;
      if (fields.back().empty()) // a comma at the end begins no further field
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
    try {
      const double value = units::parse_quantity(number + " " + unit, units::Dimension::length);
      if (std::abs(value) > largest_length)
        refuse(fmt::format("{} {} is more than {} m", base::shown(number), base::shown(unit),
                           largest_length));
      return value;
    } catch (const UserError& error) {
      refuse(error.what());
    }
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

/// Interval that holds the value, and how far it lies within.
std::pair<std::size_t, double> locate(const std::vector<double>& lines, double value) {
  const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
  const auto index = static_cast<std::size_t>(above - lines.begin()) - 1;
  return {index, (value - lines[index]) / (lines[index + 1] - lines[index])};
}

bool mirrored_lines(const std::vector<double>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::abs(lines[i] + lines[lines.size() - 1 - i]) > 1e-9 * lines.back())
      return false;
  return true;
}

} // namespace

double HeightMap::interpolated(double at_x, double at_y) const {
  const auto [i, s] = locate(x, at_x);
  const auto [j, t] = locate(y, at_y);
  return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
         t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

double HeightMap::lowest(const std::array<double, 2>& size) const {
  // Least at a grid point within the plan or where a grid line meets its border.
  const auto places = [](const std::vector<double>& lines, double half) {
    std::vector<double> inside{std::max(-half, lines.front()), std::min(half, lines.back())};
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(inside),
                 [&](double line) { return std::abs(line) < half; });
    return inside;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const double at_y : places(y, size[1] / 2))
    for (const double at_x : places(x, size[0] / 2))
      least = std::min(least, interpolated(at_x, at_y));
  return least;
}

bool HeightMap::symmetric_x() const {
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  bool same = mirrored_lines(x);
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i)
      same = same && std::abs(at(i, j) - at(x.size() - 1 - i, j)) <= 1e-9 * (*high - *low);
  return same;
}

bool HeightMap::symmetric_y() const {
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  bool same = mirrored_lines(y);
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i)
      same = same && std::abs(at(i, j) - at(i, y.size() - 1 - j)) <= 1e-9 * (*high - *low);
  return same;
}

HeightMap read_height_map(const std::string& path) {
  return TableReader(path).read();
}

} // namespace ionskin
