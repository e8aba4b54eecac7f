// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace ionskin::study {

/// Runs a part of a sweep and catches its errors, so that a failure stays with the points
/// concerned.
/// @returns the reason of the failure with its remedy; empty on success
/// Throws only Interrupted.
std::optional<std::string> failure_of(const std::function<void()>& solve);

} // namespace ionskin::study
