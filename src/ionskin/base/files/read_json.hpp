// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ionskin::base {

using Json = nlohmann::ordered_json;

/// Deepest nesting of arrays and objects that is read: copying and writing a value recurse once a
/// level.
inline constexpr int deepest_json = 32;

/// Most bytes of a JSON file: a value takes up to some twenty times the memory of its text.
inline constexpr std::size_t largest_json = 16U << 20;

/// Value of a JSON text; nothing when it is not JSON or is nested deeper than `deepest_json`.
std::optional<Json> parse_json(std::string_view text);

/// Value of a JSON file, as `parse_json` gives it.
/// Throws UserError when the file cannot be read, is a folder, a pipe or a device, or is too large.
/// @param what kind of file, for the message: "plan"
/// @param most bytes
std::optional<Json> read_json(const std::filesystem::path& path, const char* what,
                              std::size_t most = largest_json);

/// Value of a JSON file that is open already, with O_NONBLOCK, as `parse_json` gives it. Throws
/// UserError as above.
/// @param path for the message
std::optional<Json> read_json(const FileDescriptor& file, const std::string& path, const char* what,
                              std::size_t most = largest_json);

} // namespace ionskin::base
