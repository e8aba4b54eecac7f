// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cholmod.h>

#include <algorithm>
#include <cstddef>

namespace ionskin::linear_algebra {

/// The panels of a supernodal factor: dense columns over a common list of rows, which begins with
/// their own. A view.
struct CholeskyPanels {
  int size = 0; ///< unknowns
  std::size_t count = 0;
  const int *first_column, *row_start, *value_start, *rows;
  const double* values;

  explicit CholeskyPanels(const cholmod_factor& factor)
      : size(static_cast<int>(factor.n)), count(factor.nsuper),
        first_column(static_cast<const int*>(factor.super)),
        row_start(static_cast<const int*>(factor.pi)),
        value_start(static_cast<const int*>(factor.px)), rows(static_cast<const int*>(factor.s)),
        values(static_cast<const double*>(factor.x)) {}
  int height(std::size_t s) const { return row_start[s + 1] - row_start[s]; }
  /// Of its columns those before an unknown.
  int columns_before(std::size_t s, int unknown) const {
    return std::min(first_column[s + 1], unknown) - first_column[s];
  }
};

} // namespace ionskin::linear_algebra
