// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"

#include <filesystem>
#include <optional>

namespace ionskin::base {

/// Computes the digest of the file of a program, which identifies its build. Nothing (`nullopt`)
/// when the file cannot be read.
std::optional<Digest> build_digest(const std::filesystem::path& program);

/// Digest of the running program or Python module, computed once. Stored results carry it, so that
/// no build reuses results of another. Nothing (`nullopt`) when the file cannot be read.
const std::optional<Digest>& own_build();

} // namespace ionskin::base
