// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <string>
#include <vector>

namespace ionskin::results {

/// Checks of the values read from a strain file. Each check throws UserError naming the file, the
/// dataset and index, the actual value and the remedy. In all of them `dataset` is the name of the
/// dataset for the message.
class StrainFileChecks {
public:
  /// @param file name of the strain file for messages
  explicit StrainFileChecks(std::string file) : file_(std::move(file)) {}

  /// Throws UserError with the name of the file, a problem and its remedy.
  /// @param problem a clause that follows the name of the file
  /// @param remedy what the user can do
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

  /// Requires that all values are finite.
  void finite(const std::string& dataset, const std::vector<double>& values) const;
  /// Requires that all values of one sample of a channel are finite and of a magnitude up to
  /// `largest`, in the unit of the channel.
  /// @param sample index of the sample in `history.time`
  /// @param field its values [z][y][x]
  void finite_field(const std::string& dataset, const history::CoreHistory& history,
                    std::size_t sample, const history::StrainField& field, double largest) const;
  /// Requires at least two values, all finite and strictly ascending.
  void ascending(const std::string& dataset, const std::vector<double>& values) const;
  /// Requires times up to 1e7 s in magnitude and at least 1e-15 s apart; others were meant in
  /// another unit, or are damage.
  void sane_times(const std::vector<double>& values) const;
  /// Requires lengths up to 100 m in magnitude and at least 1e-15 m apart.
  void sane_lengths(const std::string& dataset, const std::vector<double>& values) const;
  /// Requires positions up to 100 m in magnitude, in any order.
  void sane_positions(const std::string& dataset, const std::vector<double>& values) const;
  /// Requires one entry per sample.
  void same_length(const std::string& dataset, std::size_t actual, std::size_t samples) const;
  /// Requires the shape [samples][z nodes][y cells][x cells].
  void shape(const std::string& dataset, const history::StrainGrid& grid, std::size_t samples,
             const std::vector<std::size_t>& actual) const;
  /// Requires that the grid covers the core of the skin: along x and y at every sample (in the
  /// slider frame, at every position of the slider), and along z exactly, from bottom to top.
  void covers_core(const history::CoreHistory& history, const Skin& skin) const;
  /// Requires that every entry of `history.event_time` is one of `history.time`.
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
