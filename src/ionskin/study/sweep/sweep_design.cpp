// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_design.hpp"

#include "ionskin/base/error.hpp"

#include <boost/random/sobol.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

namespace ionskin::study {
namespace {

/// Upper 53 of 64 random bits as a number in [0, 1).
double fraction(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

std::vector<std::vector<double>> sobol_points(std::size_t points, std::size_t dimensions,
                                              std::uint64_t seed) {
  boost::random::sobol sequence(dimensions);
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> shift(dimensions);
  for (auto& bits : shift) {
    bits = random();
  }
  std::vector<std::vector<double>> result(points, std::vector<double>(dimensions));
  for (auto& point : result) {
    for (std::size_t i = 0; i < dimensions; ++i) {
      point[i] = fraction(sequence() ^ shift[i]);
    }
  }
  return result;
}

std::vector<std::vector<double>> latin_points(std::size_t points, std::size_t dimensions,
                                              std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> result(points, std::vector<double>(dimensions));
  for (std::size_t i = 0; i < dimensions; ++i) {
    for (std::size_t n = 0; n < points; ++n) {
      result[n][i] = (static_cast<double>(n) + fraction(random())) / static_cast<double>(points);
    }
    // std::shuffle differs between standard libraries.
    for (std::size_t n = points - 1; n > 0; --n) {
      const auto other = static_cast<std::size_t>(fraction(random()) * static_cast<double>(n + 1));
      std::swap(result[n][i], result[other][i]);
    }
  }
  return result;
}

constexpr std::size_t most_points = 100'000;             // each has a folder
constexpr std::size_t most_values_of_points = 2'000'000; // number of keys times number of points
constexpr std::size_t most_bytes = 128U << 20;           // size of all values as texts

void require_countable(std::size_t points, std::size_t keys, const char* remedy) {
  if (points > most_points) {
    throw UserError(fmt::format("the sweep has more than {} points\n  = {}", most_points, remedy));
  }
  if (points * keys > most_values_of_points) {
    throw UserError(fmt::format("the sweep has {} keys at {} points, more than {} values\n  = vary "
                                "fewer keys, or {}",
                                keys, points, most_values_of_points, remedy));
  }
}

void require_short(std::size_t points, std::size_t bytes) {
  if (bytes > most_bytes / std::max<std::size_t>(1, points)) {
    throw UserError(
        fmt::format("the values of --over have {} bytes at each of {} points, more than "
                    "{} in all\n  = give fewer values, or shorter ones",
                    bytes, points, most_bytes));
  }
}

std::size_t longest_of(const std::vector<std::string>& values) {
  std::size_t longest = 0;
  for (const std::string& value : values) {
    longest = std::max(longest, value.size());
  }
  return longest;
}

} // namespace

std::vector<std::vector<std::string>> grid_design(const std::vector<SweepAxis>& axes) {
  std::vector<std::vector<std::string>> points{{}};
  std::size_t bytes = 0;
  for (const SweepAxis& axis : axes) {
    if (axis.interval) {
      throw UserError(fmt::format("--over {0} gives the ends of an interval without saying which "
                                  "points to take\n  = write --over {0}=first:step:last, or give "
                                  "--samples N",
                                  axis.key));
    }
    require_countable(points.size() * axis.values.size(), axes.size(),
                      "give --over fewer values, or take --samples N of intervals");
    bytes += longest_of(axis.values);
    require_short(points.size() * axis.values.size(), bytes);
    std::vector<std::vector<std::string>> longer;
    for (const auto& point : points) {
      for (const std::string& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<std::vector<double>> unit_points(Sampling sampling, std::size_t points,
                                             std::size_t dimensions, std::uint64_t seed) {
  return sampling == Sampling::sobol ? sobol_points(points, dimensions, seed)
                                     : latin_points(points, dimensions, seed);
}

std::vector<std::vector<std::string>> sampled_design(const std::vector<SweepAxis>& axes,
                                                     Sampling sampling, std::size_t points,
                                                     std::uint64_t seed) {
  require_countable(points, axes.size(), "give fewer --samples");
  for (const SweepAxis& axis : axes) {
    if (!axis.interval) {
      throw UserError(
          fmt::format("--samples needs intervals, but --over {0} gives values\n  = write --over "
                      "{0}=lowest:highest, or leave out --samples for a grid",
                      axis.key));
    }
  }
  std::vector<std::vector<std::string>> result;
  for (const auto& place : unit_points(sampling, points, axes.size(), seed)) {
    auto& values = result.emplace_back();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const SweepAxis::Interval& interval = *axes[i].interval;
      values.push_back(fmt::format("{:.12g}{}{}",
                                   interval.lower + place[i] * (interval.upper - interval.lower),
                                   interval.unit.empty() ? "" : " ", interval.unit));
    }
  }
  return result;
}

} // namespace ionskin::study
