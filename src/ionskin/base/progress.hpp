// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace ionskin::base {

/// Callback through which the solvers report progress: name of the activity, and its finished
/// fraction in [0, 1]. A function that calls it from several threads at once says so.
using ProgressCallback = std::function<void(std::string_view activity, double fraction)>;

/// Progress callback that does nothing.
inline void no_progress(std::string_view, double) {}

/// Progress callback for a part of an activity: maps its fractions 0 to 1 to the fractions `first`
/// to `first + share` of the whole activity.
/// @param whole callback of the whole activity, which must outlive the result
inline ProgressCallback share_of(const ProgressCallback& whole, double first, double share) {
  return [&whole, first, share](std::string_view activity, double fraction) {
    whole(activity, first + share * fraction);
  };
}

} // namespace ionskin::base
