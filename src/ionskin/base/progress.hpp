// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace ionskin::base {

/// Receiver of the progress of the physics: the name of the activity and the finished fraction in
/// [0, 1]. May be called from several threads at once only where a function says so.
using ProgressCallback = std::function<void(std::string_view activity, double fraction)>;

/// Progress callback that ignores what it is given.
inline void no_progress(std::string_view, double) {}

/// A part of an activity, which takes it from `first` to `first + share`.
/// @param whole must outlive the result
inline ProgressCallback share_of(const ProgressCallback& whole, double first, double share) {
  return [&whole, first, share](std::string_view activity, double fraction) {
    whole(activity, first + share * fraction);
  };
}

} // namespace ionskin::base
