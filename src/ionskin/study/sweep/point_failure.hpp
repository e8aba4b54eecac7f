// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace ionskin::study {

/// Solves a part of a sweep. What goes wrong there stays with its points: returned is the reason,
/// with the remedy, or nothing when all went well. Only Interrupted is passed on.
std::optional<std::string> failure_of(const std::function<void()>& solve);

} // namespace ionskin::study
