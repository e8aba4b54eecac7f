// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/error_parts.hpp"

#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/tail_current.hpp"
#include "ionskin/study/errors/metric_neighbours.hpp"
#include "ionskin/study/errors/signal_difference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace ionskin::study {
namespace {

using readout::Metric;
using readout::Signal;
using readout::SignalTable;

/// Number of rows on either side whose differences count for the band at a row, since the
/// difference of two coarse solutions changes sign from row to row.
constexpr std::ptrdiff_t band_reach = 2;

// Order of convergence and factor of safety, see `safety`.
constexpr double verified_order = 1.8, richardson_safety = 2.0;

/// Metric or signal with a name; null if there is none.
template <class Named>
const Named* find_by_name(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::ranges::find(list, name, &Named::name);
  return found == list.end() ? nullptr : &*found;
}

double value_of(const Signals& signals, const std::string& name) {
  const Metric* metric = find_by_name(signals.metrics, name);
  return metric == nullptr ? std::nan("") : metric->value;
}

/// Differences of one pair of solutions on the rows of the run.
struct PairDifference {
  const ErrorPair* pair;
  TableDifference resolved, sampled;
  std::optional<TableDifference> taxels, circuit, water;
};

PairDifference difference_of(const Signals& base, const ErrorPair& pair) {
  PairDifference result{&pair,
                        resolved_difference(base.resolved, *pair.finer, *pair.coarser),
                        table_difference(base.sampled, pair.finer->sampled, pair.coarser->sampled),
                        std::nullopt,
                        std::nullopt,
                        std::nullopt};
  const auto optional_table = [&](std::optional<SignalTable> Signals::*table) {
    const bool all = base.*table && pair.finer->*table && pair.coarser->*table;
    return all ? std::optional(table_difference(*(base.*table), *(pair.finer->*table),
                                                *(pair.coarser->*table)))
               : std::nullopt;
  };
  result.taxels = optional_table(&Signals::taxels);
  result.circuit = optional_table(&Signals::circuit);
  result.water = optional_table(&Signals::water);
  return result;
}

/// Norm over the run of the difference of a signal over the norm of the signal [1]; 0 for a signal
/// that no table has.
double relative_norm(const PairDifference& difference, const std::string& signal) {
  for (const TableDifference* table : {&difference.sampled, &difference.resolved,
                                       difference.circuit ? &*difference.circuit : nullptr,
                                       difference.water ? &*difference.water : nullptr}) {
    if (table != nullptr && table->relative_norm.contains(signal)) {
      return table->relative_norm.at(signal);
    }
  }
  return 0;
}

/// True of currents, charges and voltages, and of a current over a known noise.
bool is_electrical(const std::string& name, const std::string& unit) {
  return unit == "A" || unit == "C" || unit == "V" ||
         name.find("signal_to_noise") != std::string::npos;
}

/// True if the quantity is made by water pressure under a law that moves water: currents, charges,
/// voltages and pressures.
bool is_of_water(const std::string& name, const std::string& unit) {
  return is_electrical(name, unit) || unit == "V/N" ||
         name.find("pressure_difference") != std::string::npos ||
         name.find("pore_pressure") != std::string::npos || name == "pressure_asymmetry";
}

class MetricErrors {
public:
  MetricErrors(const Signals& base, const std::vector<PairDifference>& differences,
               const ErrorFloors& floors)
      : base_(base), differences_(differences), floors_(floors) {}

  /// Error of a metric by part, in the unit of the metric.
  std::map<std::string, double> parts(const Metric& metric) const {
    std::map<std::string, double> result;
    for (const PairDifference& difference : differences_) {
      result[difference.pair->part] += part(metric, difference);
    }
    if (const Metric* given = find_by_name(floors_.imposed.metrics, metric.name)) {
      for (auto& [name, error] : result) {
        error = 0;
      }
      result[error_parts::path] = given->value;
      return result;
    }
    if (const auto path = result.find(error_parts::path); path != result.end()) {
      path->second = std::max(path->second, floors_.path * std::abs(metric.value));
    }
    if (const Metric* least = find_by_name(floors_.cells, metric.name)) {
      double& mesh = result[error_parts::mechanics_mesh];
      mesh = std::max(mesh, least->value);
    }
    if (floors_.decoupling > 0 && is_of_water(metric.name, metric.unit)) {
      result[error_parts::decoupling] = floors_.decoupling * std::abs(metric.value);
    }
    if (floors_.thin_layers > 0 && is_electrical(metric.name, metric.unit)) {
      result[error_parts::thin_layers] = floors_.thin_layers * std::abs(metric.value);
    }
    if (const double left = rounding(metric); left > 0) {
      result[error_parts::rounding] = left;
    }
    return result;
  }

  /// Error in a metric that rounding of the charges may cause. For a current the charge is divided
  /// by the readout interval or, for resolved currents, by the shortest time step.
  double rounding(const Metric& metric) const {
    if (metric.unit == "C") {
      return floors_.charge;
    }
    if (metric.unit != "A") {
      return 0;
    }
    const std::vector<double>& time = base_.resolved.column("time").values;
    double shortest = floors_.sample_interval;
    for (std::size_t row = 1; row < time.size(); ++row) {
      shortest = std::min(shortest, time[row] - time[row - 1]);
    }
    if (metric.name.starts_with("peak_sampled") || metric.name.starts_with("tail") ||
        metric.name.starts_with("precursor")) {
      return floors_.charge / floors_.sample_interval;
    }
    const double span = metric.name.starts_with("rms")
                            ? std::sqrt(shortest * (time.back() - time.front()))
                            : shortest;
    return floors_.charge / span;
  }

private:
  double own(const std::string& name, const PairDifference& difference) const {
    if (name == "tail_current_difference") {
      return readout::tail_rms(difference.sampled.table.column("current_difference").values,
                               floors_.tail);
    }
    return std::abs(value_of(*difference.pair->coarser, name) -
                    value_of(*difference.pair->finer, name));
  }

  /// Signals related to a metric; the ratio of a voltage to its noise errs as the voltage does.
  std::vector<std::string> signals_of(const Metric& metric) const {
    const Metric* noise = find_by_name(base_.metrics, "sample_noise");
    const bool of_voltage =
        metric.name == "signal_to_noise" && noise != nullptr && noise->unit == "V";
    return related_signals(of_voltage ? "peak_voltage" : metric.name);
  }

  double part(const Metric& metric, const PairDifference& difference) const {
    double largest = own(metric.name, difference);
    const auto at_least = [&largest](double other) {
      largest = std::isnan(largest) || std::isnan(other) ? std::nan("") : std::max(largest, other);
    };
    const double value = std::abs(metric.value);
    for (const std::string& signal : signals_of(metric)) {
      at_least(value * relative_norm(difference, signal));
    }
    for (const std::string& name : related_metrics(metric.name)) {
      const double other = std::abs(value_of(base_, name));
      if (other > 0) {
        at_least(value * own(name, difference) / other);
      }
    }
    return safety(difference.pair->part, metric.name) * largest;
  }

  const Signals& base_;
  const std::vector<PairDifference>& differences_;
  const ErrorFloors& floors_;
};

/// Largest magnitude within `band_reach` rows of a row.
double largest_nearby(const std::vector<double>& values, std::size_t row) {
  double largest = 0;
  const auto at = static_cast<std::ptrdiff_t>(row);
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, at - band_reach);
       i < std::min(count, at + band_reach + 1); ++i) {
    largest = std::fmax(largest, std::abs(values[static_cast<std::size_t>(i)]));
  }
  return largest;
}

/// Errors of all columns of a table, half the width of the error band per row; `time` is unchanged.
SignalTable band(const SignalTable& base, const std::vector<PairDifference>& differences,
                 const std::function<const TableDifference*(const PairDifference&)>& table_of,
                 const ErrorFloors& floors) {
  SignalTable result = base;
  for (Signal& column : result.columns) {
    if (column.name == "time") {
      continue;
    }
    const std::vector<double> values =
        std::exchange(column.values, std::vector<double>(column.values.size(), 0.0));
    for (const PairDifference& pair : differences) {
      if (const TableDifference* table = table_of(pair)) {
        const auto part = pair_band(values, pair.pair->part, *table, column.name, floors.path);
        for (std::size_t row = 0; row < values.size(); ++row) {
          column.values[row] += part[row];
        }
      }
    }
    const double relative = relative_floor(floors, column.name, column.unit);
    for (std::size_t row = 0; row < values.size(); ++row) {
      column.values[row] += relative * std::abs(values[row]);
    }
  }
  return result;
}

/// Replaces the estimated errors of prescribed quantities by their distance from the prescription.
void take_imposed(const std::vector<Signal>& imposed, SignalTable& bands) {
  for (const Signal& given : imposed) {
    for (Signal& column : bands.columns) {
      for (std::size_t row = 0; column.name == given.name && row < given.values.size(); ++row) {
        column.values[row] = std::isnan(given.values[row]) ? column.values[row] : given.values[row];
      }
    }
  }
}

} // namespace

double relative_floor(const ErrorFloors& floors, const std::string& name, const std::string& unit) {
  return (is_of_water(name, unit) ? floors.decoupling : 0.0) +
         (is_electrical(name, unit) ? floors.thin_layers : 0.0);
}

double safety(const std::string& part, const std::string& quantity) {
  const bool of_second_order = part == error_parts::transport_grid ||
                               part == error_parts::time_steps ||
                               (part == error_parts::mechanics_mesh && !hangs_on_edges(quantity));
  return of_second_order ? richardson_safety / (std::pow(2.0, verified_order) - 1) : 1.0;
}

std::vector<double> pair_band(const std::vector<double>& values, const std::string& part,
                              const TableDifference& difference, const std::string& column,
                              double path_floor) {
  const std::vector<double>& gaps = difference.table.column(column).values;
  double norm = difference.relative_norm.at(column);
  for (const std::string& leading : leading_signals(column)) {
    const auto found = difference.relative_norm.find(leading);
    norm = std::max(norm, found == difference.relative_norm.end() ? 0.0 : found->second);
  }
  const double factor = safety(part, column);
  const double least = part == error_parts::path ? path_floor : 0.0;
  std::vector<double> result;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double size = std::abs(values[row]);
    result.push_back(
        std::isnan(size)
            ? size
            : std::max(factor * std::max(largest_nearby(gaps, row), norm * size), least * size));
  }
  return result;
}

ErrorEstimate combine_errors(const Signals& base, const std::vector<ErrorPair>& pairs,
                             const ErrorFloors& floors) {
  std::vector<PairDifference> differences;
  for (const ErrorPair& pair : pairs) {
    differences.push_back(difference_of(base, pair));
  }
  const MetricErrors errors(base, differences, floors);
  ErrorEstimate estimate;
  for (const Metric& metric : base.metrics) {
    if (is_audit(metric.name)) {
      estimate.not_estimated[metric.name] =
          "it is an audit of the solution or of the instrument, no quantity of the skin";
      continue;
    }
    const auto parts = errors.parts(metric);
    double sum = 0;
    for (const auto& [part, error] : parts) {
      sum += error;
    }
    if (!std::isfinite(sum) || !std::isfinite(metric.value)) {
      estimate.not_estimated[metric.name] =
          metric.name.starts_with("precursor_") ? too_few_readings : not_a_number;
    } else if (metric.unit == "A" && std::abs(metric.value) <= errors.rounding(metric)) {
      estimate.not_estimated[metric.name] = "rounding alone makes it";
    } else {
      estimate.parts[metric.name] = parts;
      if (metric.value != 0) {
        estimate.relative[metric.name] = sum / std::abs(metric.value);
      }
    }
  }
  estimate.signals = band(
      base.resolved, differences, [](const auto& pair) { return &pair.resolved; }, floors);
  take_imposed(floors.imposed.signals, estimate.signals);
  estimate.sampled = band(
      base.sampled, differences, [](const auto& pair) { return &pair.sampled; }, floors);
  const auto optional_band = [&](const std::optional<SignalTable>& table,
                                 std::optional<TableDifference> PairDifference::*of) {
    return table
               ? std::optional(band(
                     *table, differences,
                     [of](const PairDifference& pair) { return pair.*of ? &*(pair.*of) : nullptr; },
                     floors))
               : std::nullopt;
  };
  estimate.taxels = optional_band(base.taxels, &PairDifference::taxels);
  estimate.circuit = optional_band(base.circuit, &PairDifference::circuit);
  estimate.water = optional_band(base.water, &PairDifference::water);
  return estimate;
}

} // namespace ionskin::study
