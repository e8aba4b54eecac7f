// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/fit_data.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/base/value_at.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/text/csv_table.hpp"
#include "ionskin/readout/charge_relaxation.hpp"
#include "ionskin/units/unit_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace ionskin::study {

namespace {

/// True if the text of a cell is NaN, which MATLAB and numpy write where nothing was measured.
bool is_nan(std::string_view cell) {
  double value = 0;
  const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return status == std::errc() && end == cell.data() + cell.size() && std::isnan(value);
}

/// Weights of the charges of top and bottom electrode in a signal [1].
struct Weights {
  double top = 0, bottom = 0;
};

/// Kind of column of taxels.csv: prefix before the taxel's name, unit, and where its values come
/// from.
struct TaxelColumn {
  const char* prefix;
  const char* unit;
  std::vector<double> electrochemistry::SegmentCharge::*values;
  /// Weight of the charge of the bottom electrode below the taxel, which is added [1].
  double bottom = 0;
  double factor = 1;
  /// True if it needs a taxel with a circuit of its own, and if it needs a law that moves water.
  bool of_circuit = false, of_water = false;
};

using Segment = electrochemistry::SegmentCharge;
constexpr std::array<TaxelColumn, 9> taxel_columns{
    {{"voltage_", "V", &Segment::voltage, 0, 1, true},
     {"current_circuit_", "A", &Segment::passed, 0, 1, true},
     {"charge_circuit_", "C", &Segment::passed, 0, 1, true},
     {"current_top_", "A", &Segment::charge},
     {"charge_top_", "C", &Segment::charge},
     {"current_odd_", "A", &Segment::charge, -1, 0.5, false, true},
     {"charge_odd_", "C", &Segment::charge, -1, 0.5, false, true},
     {"current_even_", "A", &Segment::charge, 1, 0.5, false, true},
     {"charge_even_", "C", &Segment::charge, 1, 0.5, false, true}}};

const TaxelColumn* taxel_column(const std::string& column) {
  const auto found = std::ranges::find_if(
      taxel_columns, [&](const TaxelColumn& one) { return column.starts_with(one.prefix); });
  return found == taxel_columns.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(const FitColumns& columns) {
  std::vector<std::string> names;
  for (const auto& [name, unit] : columns) {
    names.push_back(name);
  }
  return names;
}

/// Names of the known columns for messages, at most 24, and how many more there are.
std::string known_words(const FitColumns& columns) {
  constexpr std::size_t most = 24;
  std::vector<std::string> names = names_of(columns);
  const std::size_t more = names.size() > most ? names.size() - most : 0;
  names.resize(names.size() - more);
  return fmt::format("known: {}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more of taxels", more) : "");
}

} // namespace

FitColumns fit_columns(const Case& input) {
  FitColumns columns = {
      {"charge_bottom", "C"},  {"charge_top", "C"},         {"current_bottom", "A"},
      {"current_common", "A"}, {"current_difference", "A"}, {"current_top", "A"},
      {"voltage", "V"}};
  const Readout& readout = input.readout;
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    for (const TaxelColumn& one : taxel_columns) {
      // Where lines are not scanned, the charges of single crossings cannot be told apart.
      const bool is_passed =
          !readout.is_crossbar() || readout.scan.dwell > 0 || one.values != &Segment::passed;
      if ((!one.of_circuit || readout.has_own_circuit(i)) && is_passed &&
          (!one.of_water || moves_water(input))) {
        columns[one.prefix + readout.taxels[i].name] = one.unit;
      }
    }
  }
  for (const Taxel& line : readout.lines()) {
    for (const TaxelColumn& one : taxel_columns) {
      if (one.of_circuit) {
        columns[one.prefix + line.name] = one.unit;
      }
    }
  }
  return columns;
}

std::string taxel_of(const std::string& column) {
  const TaxelColumn* found = taxel_column(column);
  return found == nullptr ? "" : column.substr(std::string_view(found->prefix).size());
}

namespace {

/// Median interval between the rows of a record at one rate [s]; infinity for other records.
double rate_interval(const FitData& data) {
  constexpr double alike = 0.3, enough = 0.8;
  std::vector<double> steps;
  for (std::size_t row = 1; row < data.time.size(); ++row) {
    steps.push_back(data.time[row] - data.time[row - 1]);
  }
  if (steps.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<double> ordered = steps;
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), middle, ordered.end());
  const auto regular = std::ranges::count_if(
      steps, [&](double step) { return std::abs(step - *middle) < alike * *middle; });
  return static_cast<double>(regular) >= enough * static_cast<double>(steps.size())
             ? *middle
             : std::numeric_limits<double>::infinity();
}

} // namespace

bool is_at_one_rate(const FitData& data) {
  return std::isfinite(rate_interval(data));
}

namespace {

/// Reads one signal from a CSV file, with messages that name the line.
class Reader {
public:
  Reader(const std::filesystem::path& path, const FitColumns& known)
      : table_(path.string(), "data"), known_(known) {
    for (const CsvTitle& title : table_.titles()) {
      titles_.push_back({title.name, title.unit.value_or("")});
    }
  }

  FitData read(const std::string& column) {
    const std::size_t time = find("time"), value = find(choose(column));
    FitData data{titles_[value].name, known_.at(titles_[value].name), {}, {}};
    require_unit(titles_[time], "s");
    require_unit(titles_[value], data.unit);
    while (const auto row = table_.next()) {
      take_row(*row, time, value, data);
    }
    data.at_one_rate = is_at_one_rate(data);
    return data;
  }

private:
  struct Title {
    std::string name, unit;
  };

  std::size_t find(const std::string& name) const {
    const auto found =
        std::ranges::find_if(titles_, [&](const Title& one) { return one.name == name; });
    if (found == titles_.end()) {
      table_.refuse(fmt::format("there is no column {}", name),
                    "write a header with units, such as: time [s],current_difference [A]");
    }
    if (std::ranges::count(titles_, name, &Title::name) > 1) {
      table_.refuse(fmt::format("the column {} appears twice", name), "keep one of them");
    }
    return static_cast<std::size_t>(found - titles_.begin());
  }

  std::string choose(const std::string& column) const {
    const std::string known = known_words(known_);
    if (!column.empty()) {
      if (known_.count(column) == 0) {
        const std::string nearest = base::nearest_name(column, names_of(known_));
        throw UserError(
            fmt::format("--column {} is not a signal to fit\n  = {}{}", base::shown(column),
                        nearest.empty() ? "" : "did you mean " + nearest + "? ", known));
      }
      return column;
    }
    std::vector<std::string> found;
    for (const Title& one : titles_) {
      if (known_.count(one.name) > 0 && std::ranges::find(found, one.name) == found.end()) {
        found.push_back(one.name);
      }
    }
    if (found.empty()) {
      table_.refuse("no column is a signal to fit", known);
    }
    if (found.size() > 1) {
      table_.refuse(fmt::format("several columns are signals to fit: {}", fmt::join(found, ", ")),
                    "choose one with --column");
    }
    return found.front();
  }

  void require_unit(const Title& column, const std::string& si) const {
    if (!units::convert_unit(1.0, column.unit, si)) {
      table_.refuse(fmt::format("the unit [{}] of {} does not convert to {}",
                                base::shown(column.unit), column.name, si),
                    fmt::format("write the header {} [{}]", column.name, si));
    }
  }

  double number(const std::string& text, const Title& column, const std::string& si) const {
    double value = 0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, status] = std::from_chars(begin, text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      table_.refuse(
          fmt::format("\"{}\" in column {} is not a number", base::shown(text), column.name),
          "leave the entry empty where nothing was measured");
    }
    const double converted = *units::convert_unit(value, column.unit, si);
    if (!std::isfinite(converted)) {
      table_.refuse(fmt::format("\"{}\" in column {} is too large", base::shown(text), column.name),
                    "check the number and the unit in the header");
    }
    return converted;
  }

  void take_row(const std::vector<std::string>& row, std::size_t time, std::size_t value,
                FitData& data) {
    if (row[value].empty() || is_nan(row[value])) {
      return;
    }
    const double instant = number(row[time], titles_[time], "s");
    const double measured = number(row[value], titles_[value], data.unit);
    if (!data.time.empty() && instant == data.time.back()) {
      if (measured == data.values.back()) { // the same row again
        return;
      }
      table_.refuse(fmt::format("the time {} {} appears twice, with {} and now with {}", row[time],
                                titles_[time].unit, last_, row[value]),
                    "average the values of one time, or drop all rows of it but one");
    }
    if (!data.time.empty() && instant < data.time.back()) {
      table_.refuse(fmt::format("the time {} {} does not ascend", row[time], titles_[time].unit),
                    "sort the rows by time");
    }
    data.time.push_back(instant);
    data.values.push_back(measured);
    last_ = row[value];
  }

  CsvTable table_;
  const FitColumns& known_;
  std::vector<Title> titles_;
  std::string last_; ///< last value, as written in the file
};

Weights weights(const std::string& column) {
  if (column == "current_difference") {
    return {0.5, -0.5};
  }
  if (column == "current_common") {
    return {0.5, 0.5};
  }
  return column.ends_with("_bottom") ? Weights{0, 1} : Weights{1, 0};
}

double value_of_taxel(const std::string& column, const electrochemistry::IonSolution& ions,
                      double instant) {
  const TaxelColumn& kind = *taxel_column(column);
  const Segment* taxel = nullptr;
  for (const auto* segments : {&ions.top_segments, &ions.lines}) {
    for (const Segment& segment : *segments) {
      taxel = segment.name == taxel_of(column) ? &segment : taxel;
    }
  }
  if (taxel == nullptr) {
    throw InternalError("the solution has no taxel of the column " + column);
  }
  double value = base::value_at(ions.time, taxel->*kind.values, instant);
  if (kind.bottom != 0) {
    value += kind.bottom * base::value_at(ions.time, taxel->bottom_charge, instant);
  }
  return kind.factor * value;
}

/// Charge of which a current is the rate, a charge, or a voltage of a solution at an instant [C] or
/// [V].
double value_at(const std::string& column, const electrochemistry::IonSolution& ions,
                double instant) {
  if (!taxel_of(column).empty()) {
    return value_of_taxel(column, ions, instant);
  }
  if (column == "voltage") {
    return base::value_at(ions.time, ions.voltage, instant);
  }
  const auto [top, bottom] = weights(column);
  const double relaxed = readout::departure_from_line(
      ions.time, {ions.relaxation_charge, ions.relaxation_current}, instant);
  return top * base::value_at(ions.time, ions.charge_top, instant) +
         bottom * base::value_at(ions.time, ions.charge_bottom, instant) + (top - bottom) * relaxed;
}

} // namespace

FitData read_fit_data(const std::filesystem::path& path, const FitColumns& known,
                      const std::string& column) {
  return Reader(path, known).read(column);
}

bool is_current(const FitData& data) {
  return data.column.starts_with("current_");
}

bool is_mean(const FitData& data) {
  return is_current(data) || (data.at_one_rate && data.column.starts_with("voltage"));
}

std::vector<double> interval_starts(const FitData& data, double start) {
  constexpr double gap = 1.75; // in intervals of the record
  const double interval = rate_interval(data);
  std::vector<double> starts;
  for (std::size_t row = 1; row < data.time.size(); ++row) {
    const bool behind_gap = data.time[row] - data.time[row - 1] > gap * interval;
    starts.push_back(behind_gap ? data.time[row] - interval : data.time[row - 1]);
  }
  const double first = data.time.front();
  const double before = starts.empty() ? start : first - (data.time[1] - starts.front());
  starts.insert(starts.begin(), first > start ? std::max(start, before) : before);
  return starts;
}

namespace {

[[noreturn]] void refuse_late(const FitData& data, double start, double end) {
  const double span = end - start, length = data.time.back() - data.time.front();
  if (length > 100 * span) {
    throw UserError(
        fmt::format("the data last {:.6g} s, the run {:.6g} s\n  = are the times in ms, "
                    "us or ns? name their unit in the header, such as time [ms]; else "
                    "cut the data",
                    length, span));
  }
  const double first = interval_starts(data, start).front();
  if (data.time.front() > start + 0.05 * span && length < span * (1 + 1e-3)) {
    throw UserError(fmt::format(
        "the times do not count from the beginning of the run: your first time is {0:.13g} s, the "
        "last {1:.13g} s, and the run goes from {2:.6g} s to {3:.6g} s\n  = subtract it: {4:.13g} "
        "s "
        "from all times, if the record begins with the run; or let the fit find the shift: --free "
        "data.time_shift",
        data.time.front(), data.time.back(), start, end, first - start));
  }
  throw UserError(fmt::format("the data reach to t = {:.13g} s, the run ends at {:.6g} s\n  = cut "
                              "the data, let the run last longer (motion.cycles), or free "
                              "data.time_shift where their clock is late",
                              data.time.back(), end));
}

} // namespace

void restrict_to_run(FitData& data, double start, double end) {
  const double slack = 1e-9 * (end - start);
  if (!data.time.empty() && data.time.back() > end + slack) {
    refuse_late(data, start, end);
  }
  const auto early = [&](double instant) {
    return is_mean(data) ? instant <= start + slack : instant < start - slack;
  };
  const auto dropped = std::ranges::find_if_not(data.time, early) - data.time.begin();
  data.time.erase(data.time.begin(), data.time.begin() + dropped);
  data.values.erase(data.values.begin(), data.values.begin() + dropped);
  if (data.time.empty()) {
    throw UserError(fmt::format("the data hold no row of {} that the run from {:.6g} s to {:.6g} s "
                                "can answer\n  = the time counts from the beginning of the run",
                                data.column, start, end));
  }
}

namespace {

/// Mean between two instants of a quantity that is linear between known instants.
/// @param instants known instants, ascending [s]
/// @param value quantity as a function of time
template <class Value>
double mean_between(const std::vector<double>& instants, const Value& value, double from,
                    double to) {
  double sum = 0.0, last = from, last_value = value(from);
  const auto take = [&](double instant) {
    const double here = value(instant);
    sum += 0.5 * (instant - last) * (here + last_value);
    last = instant;
    last_value = here;
  };
  for (auto at = std::ranges::upper_bound(instants, from); at != instants.end() && *at < to; ++at) {
    take(*at);
  }
  take(to);
  return to > from ? sum / (to - from) : last_value;
}

} // namespace

std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions) {
  const auto at = [&](double instant) { return value_at(data.column, ions, instant); };
  std::vector<double> result(data.time.size());
  if (!is_mean(data)) {
    std::ranges::transform(data.time, result.begin(), at);
    return result;
  }
  const std::vector<double> starts = interval_starts(data, ions.time.front());
  for (std::size_t row = 0; row < result.size(); ++row) {
    const double interval = data.time[row] - starts[row];
    if (is_current(data)) {
      result[row] = interval > 0 ? (at(data.time[row]) - at(starts[row])) / interval : 0.0;
    } else {
      result[row] = mean_between(ions.time, at, starts[row], data.time[row]);
    }
  }
  return result;
}

} // namespace ionskin::study
