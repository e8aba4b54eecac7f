// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/strain_file/strain_file_checks.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::results {
namespace {

// Relative tolerance of lengths, which may differ by rounding if users compute them in another
// order [1].
constexpr double relative_rounding = 1e-9;

// Bounds of times and lengths: values beyond them were meant in another unit, or are damage.
constexpr double longest_time = 1e7, shortest_time = 1e-15;     // [s]
constexpr double longest_length = 100, shortest_length = 1e-15; // [m]

const char* kind_of(double value) {
  return std::isnan(value) ? "NaN" : "infinite";
}

} // namespace

void StrainFileChecks::fail(const std::string& problem, const std::string& remedy) const {
  throw UserError(fmt::format("the strain file {}: {}\n  = {}", file_, problem, remedy));
}

void StrainFileChecks::finite(const std::string& dataset, const std::vector<double>& values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      fail(fmt::format("{} is {} at index {}", dataset, kind_of(values[i]), i),
           "write finite numbers");
    }
  }
}

void StrainFileChecks::finite_field(const std::string& dataset, const history::CoreHistory& history,
                                    std::size_t sample, const history::StrainField& field,
                                    double largest) const {
  const auto bad = std::find_if(field.begin(), field.end(),
                                [largest](double value) { return !(std::abs(value) <= largest); });
  if (bad == field.end()) {
    return;
  }
  const auto index = static_cast<std::size_t>(bad - field.begin());
  const std::size_t nx = history.grid.columns_x();
  const std::size_t ny = history.grid.columns_y();
  const bool finite = std::isfinite(*bad);
  fail(fmt::format("{} is {} at [time, z, y, x] = [{}, {}, {}, {}], the first such place "
                   "(time {:.6g} s, z {:.6g} m)",
                   dataset, finite ? fmt::format("{:.6g}", *bad) : kind_of(*bad), sample,
                   index / (nx * ny), index / nx % ny, index % nx, history.time[sample],
                   history.grid.z_nodes[index / (nx * ny)]),
       finite
           ? fmt::format("write values from -{0:g} to {0:g}, in the unit of the dataset", largest)
           : "write finite numbers everywhere in the core; 0 where nothing happens");
}

void StrainFileChecks::ascending(const std::string& dataset,
                                 const std::vector<double>& values) const {
  if (values.size() < 2) {
    fail(fmt::format("{} has {} entries", dataset, values.size()), "write at least two");
  }
  finite(dataset, values);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] <= values[i - 1]) {
      fail(fmt::format("{} does not ascend at index {}: {} follows {}", dataset, i, values[i],
                       values[i - 1]),
           "sort the entries and remove equal ones");
    }
  }
}

void StrainFileChecks::within(const std::string& dataset, const std::vector<double>& values,
                              double most, const std::string& unit) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(std::abs(values[i]) <= most)) {
      fail(fmt::format("{} is {} {} at index {}", dataset, values[i], unit, i),
           fmt::format("write it in {0}, from -{1} {0} to {1} {0}", unit, most));
    }
  }
}

void StrainFileChecks::apart(const std::string& dataset, const std::vector<double>& values,
                             double least, const std::string& unit) const {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] - values[i - 1] < least) {
      fail(fmt::format("{} ascends by {} {} at index {}", dataset, values[i] - values[i - 1], unit,
                       i),
           fmt::format("leave at least {} {} between neighbours", least, unit));
    }
  }
}

void StrainFileChecks::sane_times(const std::vector<double>& values) const {
  within("time", values, longest_time, "s");
  apart("time", values, shortest_time, "s");
}

void StrainFileChecks::sane_lengths(const std::string& dataset,
                                    const std::vector<double>& values) const {
  within(dataset, values, longest_length, "m");
  apart(dataset, values, shortest_length, "m");
}

void StrainFileChecks::sane_positions(const std::string& dataset,
                                      const std::vector<double>& values) const {
  within(dataset, values, longest_length, "m");
}

void StrainFileChecks::same_length(const std::string& dataset, std::size_t actual,
                                   std::size_t samples) const {
  if (actual != samples) {
    fail(fmt::format("{} has {} entries, time has {}", dataset, actual, samples),
         "write one entry per sample");
  }
}

void StrainFileChecks::shape(const std::string& dataset, const history::StrainGrid& grid,
                             std::size_t samples, const std::vector<std::size_t>& actual) const {
  const std::vector<std::size_t> expected{samples, grid.z_nodes.size(), grid.columns_y(),
                                          grid.columns_x()};
  if (actual != expected) {
    fail(fmt::format("{} has the shape {}, but [time, z, y, x] with {} samples, {} z nodes, {} y "
                     "cells and {} x cells needs {}",
                     dataset, actual, expected[0], expected[1], expected[2], expected[3], expected),
         "x and y hold cell edges (one more than cells), z holds nodes; x varies fastest");
  }
}

void StrainFileChecks::covers(const std::string& axis, const std::vector<double>& edges,
                              const std::vector<double>& offsets, double extent) const {
  const auto [least, most] = std::minmax_element(offsets.begin(), offsets.end());
  const double low = edges.front() + *most;
  const double high = edges.back() + *least;
  const double rounding = relative_rounding * extent;
  if (low > rounding || high < extent - rounding) {
    fail(
        fmt::format("the grid does not cover the core along {}: it spans {:.9g} to {:.9g} m{}, the "
                    "core 0 to {:.9g} m",
                    axis, low, high,
                    *least == *most ? "" : " (what is covered at every slider position)", extent),
        fmt::format("extend grid/{} or change the skin of the case; lengths are in metres", axis));
  }
}

void StrainFileChecks::covers_core(const history::CoreHistory& history, const Skin& skin) const {
  const bool rides = history.frame == history::Frame::slider;
  const double mid_width = rides ? 0.5 * skin.width : 0.0;
  covers("x", history.grid.x_edges, rides ? history.slider_x : std::vector<double>{0.0},
         skin.length);
  covers("y", history.grid.y_edges,
         history.slider_y.empty() ? std::vector<double>{mid_width} : history.slider_y, skin.width);
  const double thickness = skin.core_thickness();
  const double rounding = relative_rounding * thickness;
  const std::vector<double>& z = history.grid.z_nodes;
  if (std::abs(z.front()) > rounding || std::abs(z.back() - thickness) > rounding) {
    fail(fmt::format("the grid does not cover the core along z: it spans {:.9g} to {:.9g} m, the "
                     "core 0 to {:.9g} m",
                     z.front(), z.back(), thickness),
         "count grid/z in metres from 0 at the bottom of the core to its full thickness");
  }
}

void StrainFileChecks::events_are_samples(const history::CoreHistory& history) const {
  for (double event : history.event_time) {
    if (!std::binary_search(history.time.begin(), history.time.end(), event)) {
      fail(fmt::format("event_time holds {} s, which is not an entry of time", event),
           "write only instants of time into event_time, or leave it out");
    }
  }
}

} // namespace ionskin::results
