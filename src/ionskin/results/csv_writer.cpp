// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/csv_writer.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>

namespace ionskin::results {
namespace {

bool has_phases(const readout::SignalTable& table) {
  return !table.cycle.empty();
}

void append_header(const readout::SignalTable& table, std::string& text) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const readout::Signal& column = table.columns[i];
    fmt::format_to(std::back_inserter(text), "{}{} [{}]", i == 0 ? "" : ",", column.name,
                   column.unit);
    if (i == 0 && has_phases(table)) {
      text += ",cycle,phase";
    }
  }
  text += '\n';
}

void append_number(double value, std::string& text) {
  if (!std::isnan(value)) {
    fmt::format_to(std::back_inserter(text), "{}", value);
  }
}

void append_phase(const readout::SignalTable& table, std::size_t row, std::string& text) {
  text += ',';
  if (table.cycle[row] > 0) {
    fmt::format_to(std::back_inserter(text), "{}", table.cycle[row]);
  }
  text += ',';
  text += table.phase[row];
}

void append_row(const readout::SignalTable& table, std::size_t row, std::string& text) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i > 0) {
      text += ',';
    }
    append_number(table.columns[i].values[row], text);
    if (i == 0 && has_phases(table)) {
      append_phase(table, row, text);
    }
  }
  text += '\n';
}

} // namespace

std::string csv_text(const readout::SignalTable& table) {
  std::string text;
  append_header(table, text);
  for (std::size_t row = 0; row < table.columns.front().values.size(); ++row) {
    append_row(table, row, text);
  }
  return text;
}

void write_csv(const std::filesystem::path& path, const readout::SignalTable& table) {
  base::write_text_file(path, csv_text(table));
}

} // namespace ionskin::results
