// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::base {

/// Stands for a program by the content of its file; nothing when it cannot be read.
std::optional<Digest> build_digest(const std::filesystem::path& program);

/// Digest of the running program or module, so that no build takes up what another computed.
const std::optional<Digest>& own_build();

} // namespace ionskin::base
