// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::mesh {

// All lines start at 0, ascend strictly and end at `length` exactly.

/// Zone at the begin of a graded line in which elements have a bound of their own. Both lengths are
/// those before the line is scaled [m].
struct EdgeZone {
  double width = 0;   ///< of the zone, from the begin of the line [m]
  double largest = 0; ///< largest size of elements that begin within the zone [m]
};

/// Graded line: element sizes grow by a factor from the first one up to a largest one. One factor
/// then scales all sizes down so that they fill the length.
/// @param length of the line [m]
/// @param first size of the first element, before scaling [m]
/// @param growth ratio of each size to the size before [1]
/// @param largest size of any element outside of `zone`, before scaling [m]
/// @param zone bound on the sizes at the begin of the line; none by default
/// @returns the ends of the elements, from 0 to `length` [m]
/// Throws UserError when the line would have more than 100,000 elements.
std::vector<double> graded_line(double length, double first, double growth, double largest,
                                const EdgeZone& zone = {});

/// Line of `count` elements in geometric progression, whose first size is exactly `first` [m]. The
/// ratio is a smooth function of `length` [m], and below 1 when `length < count * first`. Needs
/// `length > first`.
std::vector<double> geometric_line(double length, double first, std::size_t count);

/// Line of `count` elements, each `growth` [1] times as large as the one before.
/// @param length [m]
std::vector<double> growing_line(double length, double growth, std::size_t count);

/// Line of `count` elements that grow by the factor `growth` [1] from both ends to the middle.
/// @param length [m]
std::vector<double> two_sided_line(double length, double growth, std::size_t count);

/// Ratio r [1] of a geometric progression of `count` element sizes with a given first size and sum:
/// first (1 + r + ... + r^(count-1)) = length [m]. Needs `count > 1` and `length > first`.
double geometric_ratio(double length, double first, std::size_t count);

/// Least number of elements with which a line from a first size `first` [m] reaches `length` [m] at
/// a ratio of at most `growth` [1]. Throws UserError when that takes more than 10,000 elements.
std::size_t geometric_count(double length, double first, double growth);

/// Reflects a line: the sizes of its elements come in the opposite order, and it ascends again from
/// 0 to the same length.
std::vector<double> reversed(const std::vector<double>& line);

/// Appends a line to another one.
/// @param lines [m] extended in place
/// @param line [m], moved so that it begins where `lines` ends
void append(std::vector<double>& lines, const std::vector<double>& line);

} // namespace ionskin::mesh
