// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::mesh {

// All lines start at 0, ascend strictly and end at `length` exactly.

/// Where a graded line starts, a bound on the sizes of its own; both before the line is scaled.
struct EdgeZone {
  double width = 0;
  double largest = 0; ///< of elements that begin within `width`
};

/// Sizes grow from `first` by `growth` up to `largest`, or that of `zone` inside it; all are scaled
/// down by one factor so that they fill `length`.
std::vector<double> graded_line(double length, double first, double growth, double largest,
                                const EdgeZone& zone = {});

/// `count` elements in geometric progression whose first size is exactly `first`. The ratio is a
/// smooth function of `length`; it is below 1 when `length < count * first`. Needs `length >
/// first`.
std::vector<double> geometric_line(double length, double first, std::size_t count);

/// `count` elements that grow by `growth` from the start.
std::vector<double> growing_line(double length, double growth, std::size_t count);

/// `count` elements that grow by `growth` from both ends to the middle.
std::vector<double> two_sided_line(double length, double growth, std::size_t count);

/// Ratio r with first (1 + r + ... + r^(count-1)) = length.
double geometric_ratio(double length, double first, std::size_t count);

/// Fewest elements whose geometric ratio does not exceed `growth`.
std::size_t geometric_count(double length, double first, double growth);

/// `line` reflected: ascending again, from 0 to the same length.
std::vector<double> reversed(const std::vector<double>& line);

/// Appends `line`, moved to start where `lines` ends.
void append(std::vector<double>& lines, const std::vector<double>& line);

} // namespace ionskin::mesh
