// SPDX-License-Identifier: Apache-2.0
#include "studio/data/table_data.hpp"

#include "studio/data/packed.hpp"
#include "studio/server/limits.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

namespace ionskin::apps::studio {
namespace {

using Row = std::vector<std::string>;

/// The cells of a line; quoted ones may hold commas (RFC 4180), but no line breaks.
Row cells_of(const std::string& line) {
  Row cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else if (line[i] != '\r') {
      cells.back() += line[i];
    }
  }
  return cells;
}

std::optional<double> number_of(const std::string& cell) {
  if (cell.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double value = 0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = end == cell.data() + cell.size();
  return whole && problem != std::errc::invalid_argument ? std::optional(value) : std::nullopt;
}

Json heading_of(const std::string& title) {
  const std::size_t bracket = title.rfind(" [");
  const bool has_unit = bracket != std::string::npos && title.back() == ']';
  return {{"name", has_unit ? title.substr(0, bracket) : title},
          {"unit", has_unit ? title.substr(bracket + 2, title.size() - bracket - 3) : ""}};
}

} // namespace

std::string packed_table(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) > limits::table_bytes || error) {
    throw HttpError(413, "this table is too large to be shown; Python or ParaView reads it");
  }
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const Row titles = cells_of(line);
  std::vector<std::vector<double>> numbers(titles.size());
  std::vector<Row> texts(titles.size());
  std::vector<bool> words(titles.size(), false);
  std::size_t rows = 0;
  while (std::getline(file, line)) {
    Row cells = cells_of(line);
    cells.resize(titles.size());
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const auto number = number_of(cells[i]);
      words[i] = words[i] || !number;
      numbers[i].push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
      texts[i].push_back(std::move(cells[i]));
    }
    ++rows;
  }
  Json columns = Json::array();
  std::vector<double> all;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    Json column = heading_of(titles[i]);
    column["texts"] = words[i] ? Json(texts[i]) : Json();
    columns.push_back(std::move(column));
    if (!words[i]) {
      all.insert(all.end(), numbers[i].begin(), numbers[i].end());
    }
  }
  return packed(Json{{"rows", rows}, {"columns", columns}}, all);
}

} // namespace ionskin::apps::studio
