// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_table.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/results/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace ionskin::study {
namespace {

const char* to_text(PointStatus status) {
  switch (status) {
  case PointStatus::finished:
    return "finished";
  case PointStatus::failed:
    return "failed";
  case PointStatus::pending:
    return "pending";
  }
  return "";
}

/// All metrics that any point has, in the order of their first appearance.
std::vector<readout::Metric> all_metrics(const std::vector<PointState>& states) {
  std::vector<readout::Metric> result;
  for (const PointState& state : states) {
    for (const readout::Metric& metric : state.metrics) {
      const auto known = std::find_if(result.begin(), result.end(),
                                      [&](const auto& other) { return other.name == metric.name; });
      if (known == result.end()) {
        result.push_back(metric);
      }
    }
  }
  return result;
}

double metric_value(const PointState& state, const std::string& name) {
  for (const readout::Metric& metric : state.metrics) {
    if (metric.name == name) {
      return metric.value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void copy_group(const results::ForeignHdf5File& source, const std::string& group,
                results::Hdf5File& target, const std::string& target_group) {
  if (!source.has("/" + group)) {
    return;
  }
  for (const std::string& name : source.members("/" + group)) {
    const std::string from = "/" + group + "/" + name;
    const std::string to = target_group + "/" + group + "/" + name;
    if (!source.has_numbers(from)) {
      target.write_texts(to, source.read_texts(from));
      continue;
    }
    target.write(to, source.read(from));
    if (const auto unit = source.text_attribute(from, "unit")) {
      target.set_attribute(to, "unit", *unit);
    }
  }
}

void write_swept(results::Hdf5File& file, const std::vector<SweepPoint>& points) {
  for (std::size_t k = 0; k < points.front().values.size(); ++k) {
    const SweptValue& first = points.front().values[k];
    const std::string dataset = "/swept/" + first.key;
    if (first.unit.empty()) {
      std::vector<std::string> texts;
      for (const SweepPoint& point : points) {
        texts.push_back(point.values[k].written);
      }
      file.write_texts(dataset, texts);
      continue;
    }
    std::vector<double> numbers;
    for (const SweepPoint& point : points) {
      const std::string& text = point.values[k].si;
      std::from_chars(text.data(), text.data() + text.size(), numbers.emplace_back());
    }
    file.write_with_unit(dataset, numbers, first.unit);
  }
}

} // namespace

std::string sweep_table_text(const std::vector<SweepPoint>& points,
                             const std::vector<PointState>& states) {
  const std::vector<readout::Metric> metrics = all_metrics(states);
  std::string text = "point,folder";
  for (const SweptValue& value : points.front().values) {
    text += value.unit.empty() ? fmt::format(",{}", value.key)
                               : fmt::format(",{} [{}]", value.key, value.unit);
  }
  text += ",status,reason";
  for (const readout::Metric& metric : metrics) {
    text += fmt::format(",{} [{}]", metric.name, metric.unit);
  }
  text += "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("{},{}/{}", i + 1, results::file_names::points, points[i].name);
    for (const SweptValue& value : points[i].values) {
      text += fmt::format(",{}", base::csv_cell(value.si));
    }
    text += fmt::format(",{},{}", to_text(states[i].status), base::csv_cell(states[i].reason));
    for (const readout::Metric& metric : metrics) {
      const double value = metric_value(states[i], metric.name);
      text += std::isnan(value) ? "," : fmt::format(",{}", value);
    }
    text += "\n";
  }
  return text;
}

void write_sweep_signals(const std::filesystem::path& folder, const std::filesystem::path& target,
                         const std::vector<SweepPoint>& points,
                         const std::vector<PointState>& states) {
  base::PendingFile pending(target);
  results::Hdf5File file(pending.path(), results::Hdf5File::Access::create);
  write_swept(file, points);
  for (const readout::Metric& metric : all_metrics(states)) {
    std::vector<double> values;
    for (const PointState& state : states) {
      values.push_back(metric_value(state, metric.name));
    }
    file.write_with_unit("/metrics/" + metric.name, values, metric.unit);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (states[i].status != PointStatus::finished) {
      continue;
    }
    const std::string group = "/points/" + points[i].name;
    const results::ForeignHdf5File source(folder / results::file_names::points / points[i].name /
                                          results::file_names::results);
    for (const char* table : {"signals", "sampled", "taxels", "circuit", "water", "sampled_taxels",
                              "sampled_circuit"}) {
      copy_group(source, table, file, group);
    }
    for (const SweptValue& value : points[i].values) {
      file.set_attribute(group, value.key, value.written);
    }
  }
  file.close();
  pending.commit();
}

} // namespace ionskin::study
