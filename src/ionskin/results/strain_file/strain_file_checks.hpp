// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <string>
#include <vector>

namespace ionskin::results {

/// Checks of what stands in a strain file. Each throws UserError naming the file, the place, the
/// actual value and the remedy.
class StrainFileChecks {
public:
  explicit StrainFileChecks(std::string file) : file_(std::move(file)) {}

  /// Throws UserError with the file, the problem and the remedy.
  /// @param problem a clause about the file, @param remedy what the user can do
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

  void finite(const std::string& dataset, const std::vector<double>& values) const;
  /// One sample of a channel: finite, and of a magnitude up to `largest`.
  void finite_field(const std::string& dataset, const history::CoreHistory& history,
                    std::size_t sample, const history::StrainField& field, double largest) const;
  /// Finite, strictly ascending and at least two entries.
  void ascending(const std::string& dataset, const std::vector<double>& values) const;
  /// No time and no length is absurd; nor is a step between neighbours.
  void sane_times(const std::vector<double>& values) const;
  void sane_lengths(const std::string& dataset, const std::vector<double>& values) const;
  void sane_positions(const std::string& dataset, const std::vector<double>& values) const;
  void same_length(const std::string& dataset, std::size_t actual, std::size_t samples) const;
  void shape(const std::string& dataset, const history::StrainGrid& grid, std::size_t samples,
             const std::vector<std::size_t>& actual) const;
  /// Along x and y at every sample, along z exactly.
  void covers_core(const history::CoreHistory& history, const Skin& skin) const;
  void events_are_samples(const history::CoreHistory& history) const;

private:
  void within(const std::string& dataset, const std::vector<double>& values, double most,
              const std::string& unit) const;
  void apart(const std::string& dataset, const std::vector<double>& values, double least,
             const std::string& unit) const;
  void covers(const std::string& axis, const std::vector<double>& edges,
              const std::vector<double>& offsets, double extent) const;

  std::string file_;
};

} // namespace ionskin::results
