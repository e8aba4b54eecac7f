// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_axis.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ionskin::study {

/// Design of a sampled sweep: how its points fill the intervals of its axes, see `unit_points`.
enum class Sampling { sobol, latin_hypercube };

/// Full grid of the values of all axes, the last axis fastest, [point][axis], as texts.
/// Throws UserError when an axis is an interval, or there are too many points.
std::vector<std::vector<std::string>> grid_design(const std::vector<SweepAxis>& axes);

/// Points in the unit box, [point][dimension], identical for the same seed on every machine.
/// `sobol`: low-discrepancy sequence (Sobol 1967, with the direction numbers of Joe and Kuo 2008,
/// doi 10.1137/070709359) under a random digital shift; best with powers of 2.
/// `latin_hypercube`: one point in each of N equal slices of every axis (McKay, Beckman and Conover
/// 1979, doi 10.1080/00401706.1979.10489755).
std::vector<std::vector<double>> unit_points(Sampling sampling, std::size_t points,
                                             std::size_t dimensions, std::uint64_t seed);

/// Sampled values of all axes, [point][axis], as texts with their units.
/// @param points number of points
/// Throws UserError when an axis is no interval, or there are too many points.
std::vector<std::vector<std::string>> sampled_design(const std::vector<SweepAxis>& axes,
                                                     Sampling sampling, std::size_t points,
                                                     std::uint64_t seed);

} // namespace ionskin::study
