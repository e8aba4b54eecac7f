// SPDX-License-Identifier: Apache-2.0
#include "studio/data/table_data.hpp"

#include "studio/data/packed.hpp"
#include "studio/server/limits.hpp"

#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace ionskin::apps::studio {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Removes the first cell and its comma from a line. Quoted cells may hold commas (RFC 4180), but
/// no line breaks. Returns true when another cell follows.
bool take_cell(std::string_view& line, std::string& cell) {
  cell.clear();
  bool quoted = false;
  std::size_t i = 0;
  for (; i < line.size() && (quoted || line[i] != ','); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cell += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] != '\r') {
      cell += line[i];
    }
  }
  const bool more = i < line.size();
  line.remove_prefix(more ? i + 1 : i);
  return more;
}

std::optional<double> number_of(const std::string& cell) {
  if (cell.empty()) {
    return missing;
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

[[noreturn]] void refuse() {
  throw HttpError(413, "this table is too large to be shown; Python or ParaView reads it");
}

/// CSV file that is read line by line, as often as `begin` is called.
class Lines {
public:
  explicit Lines(const std::filesystem::path& path)
      : file_(path), buffer_(limits::table_line, '\0') {}

  /// Starts at the beginning and returns the heading line; the next call of `next` gives the first
  /// row.
  std::string_view begin() {
    file_.clear();
    file_.seekg(0);
    std::string_view heading;
    next(heading);
    return heading;
  }
  /// Reads the next row. Returns false at the end of the file.
  bool next(std::string_view& line) {
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto taken = static_cast<std::size_t>(file_.gcount());
    if (file_.fail() && taken > 0) {
      refuse(); // longer than the buffer
    }
    // The count has the line's end, which the last line may lack.
    line = std::string_view(buffer_).substr(0, taken - (file_.eof() || taken == 0 ? 0 : 1));
    return !file_.fail();
  }

private:
  std::ifstream file_;
  std::string buffer_;
};

std::vector<std::string> titles_of(std::string_view line) {
  std::vector<std::string> titles;
  std::string title;
  for (bool more = true; more;) {
    more = take_cell(line, title);
    if (titles.size() == limits::table_columns) {
      refuse();
    }
    titles.push_back(title);
  }
  return titles;
}

/// Shape of a table: number of rows, and the columns that hold words.
struct Shape {
  std::size_t rows = 0;
  std::vector<bool> words;
};

/// Counts the rows. Throws HttpError when they hold more cells than `limits::table_cells`.
std::size_t count_rows(Lines& lines, std::size_t columns) {
  std::size_t rows = 0;
  for (std::string_view line; lines.next(line);) {
    if (++rows * columns > limits::table_cells) {
      refuse();
    }
  }
  return rows;
}

/// Finds the columns that hold words. Throws HttpError when their words are too many or too long,
/// see `limits`.
Shape shape_of(Lines& lines, std::size_t rows, std::size_t columns) {
  Shape shape{rows, std::vector<bool>(columns, false)};
  std::vector<std::size_t> bytes(columns, 0);
  std::string cell;
  std::string_view line;
  for (std::size_t row = 0; row < rows && lines.next(line); ++row) {
    for (std::size_t i = 0; i < columns; ++i) {
      take_cell(line, cell);
      shape.words[i] = shape.words[i] || !number_of(cell);
      bytes[i] += cell.size();
    }
  }
  std::size_t words = 0, text = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    words += shape.words[i] ? shape.rows : 0;
    text += shape.words[i] ? bytes[i] : 0;
  }
  if (words > limits::table_words || text > limits::table_text) {
    refuse();
  }
  return shape;
}

} // namespace

std::string packed_table(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) > limits::table_bytes || error) {
    refuse();
  }
  Lines lines(path);
  const auto titles = titles_of(lines.begin());
  // Counted first: what is refused is refused before its cells are read.
  const std::size_t rows = count_rows(lines, titles.size());
  lines.begin();
  const Shape shape = shape_of(lines, rows, titles.size());
  Json heading = {{"rows", shape.rows}, {"columns", Json::array()}};
  Json& columns = heading["columns"];
  std::vector<std::size_t> begins; // of the columns of numbers
  std::size_t count = 0;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    columns.push_back(heading_of(titles[i]));
    columns.back()["texts"] = shape.words[i] ? Json::array() : Json();
    begins.push_back(count);
    count += shape.words[i] ? 0 : shape.rows;
  }
  std::vector<double> numbers(count, missing);
  std::string cell;
  std::string_view line;
  lines.begin();
  for (std::size_t row = 0; row < shape.rows && lines.next(line); ++row) {
    for (std::size_t i = 0; i < titles.size(); ++i) {
      take_cell(line, cell);
      if (shape.words[i]) {
        columns[i]["texts"].push_back(cell);
      } else {
        numbers[begins[i] + row] = number_of(cell).value_or(missing);
      }
    }
  }
  return packed(heading, numbers);
}

} // namespace ionskin::apps::studio
