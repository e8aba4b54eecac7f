// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace ionskin::base {

/// How the physics tells how far it is: the name of the activity and the finished fraction in [0,
/// 1]. May be called from several threads at once only where a function says so.
using ProgressCallback = std::function<void(std::string_view activity, double fraction)>;

/// For callers who do not want to know.
inline void no_progress(std::string_view, double) {}

} // namespace ionskin::base
