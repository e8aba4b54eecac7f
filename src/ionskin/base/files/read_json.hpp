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

/// JSON value that keeps the order of the members of objects.
using Json = nlohmann::ordered_json;

/// Deepest nesting of arrays and objects that `parse_json` accepts, because copying and writing a
/// value recurse once per level.
inline constexpr int deepest_json = 32;

/// Default limit of the size of a JSON file [bytes]. A value takes up to about twenty times the
/// memory of its text.
inline constexpr std::size_t largest_json = 16U << 20;

/// Parses a JSON text. Nothing (`nullopt`) when it is not JSON or is nested deeper than
/// `deepest_json`.
std::optional<Json> parse_json(std::string_view text);

/// Reads and parses a JSON file. Nothing (`nullopt`) when its text is not JSON or is nested too
/// deep, as in `parse_json`.
/// @param what kind of file, for the message: "plan"
/// @param most largest allowed size of the file [bytes]
/// Throws UserError when the file cannot be read, is a folder, a pipe or a device, or is too large.
std::optional<Json> read_json(const std::filesystem::path& path, const char* what,
                              std::size_t most = largest_json);

/// Reads and parses a JSON file that is already open, like the overload for a path, with the same
/// errors.
/// @param file opened for reading with O_NONBLOCK
/// @param path of the file, for the message
std::optional<Json> read_json(const FileDescriptor& file, const std::string& path, const char* what,
                              std::size_t most = largest_json);

} // namespace ionskin::base
