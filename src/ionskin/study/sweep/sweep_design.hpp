// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_axis.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ionskin::study {

/// Design by which the points of a sampled sweep fill the box of its intervals.
enum class Sampling { sobol, latin_hypercube };

/// One value per axis for every point, the last axis fastest.
std::vector<std::vector<std::string>> grid_design(const std::vector<SweepAxis>& axes);

/// Points in the unit box [points][dimensions], the same for the same seed on every machine.
/// `sobol`: low-discrepancy sequence (Sobol 1967, with the direction numbers of Joe and Kuo 2008,
/// doi 10.1137/070709359) under a random digital shift; best with powers of 2.
/// `latin_hypercube`: one point in each of N equal slices of every axis (McKay, Beckman and Conover
/// 1979, doi 10.1080/00401706.1979.10489755).
std::vector<std::vector<double>> unit_points(Sampling sampling, std::size_t points,
                                             std::size_t dimensions, std::uint64_t seed);

/// One value per axis for every sampled point. All axes must be intervals. Throws UserError.
std::vector<std::vector<std::string>> sampled_design(const std::vector<SweepAxis>& axes,
                                                     Sampling sampling, std::size_t points,
                                                     std::uint64_t seed);

} // namespace ionskin::study
