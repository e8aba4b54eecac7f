// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace ionskin::results {

/// Name of the list file of an output folder: it holds the names of all files that ionskin wrote
/// there, one per line. The Python package adds the names of its figures (output_folder.py).
inline constexpr const char* file_list_name = ".ionskin-files";

/// True if `name` is a relative path to a file in a folder or in one of its direct subfolders,
/// without "." or "..": no such name leads out of the folder.
bool is_inner_name(const std::string& name);

/// Reads the names in the list file of a folder, without any that `is_inner_name` rejects. Nothing
/// (`nullopt`) when the list is missing or cannot be read.
std::optional<std::set<std::string>> read_file_list(const std::filesystem::path& folder);

/// Appends a name to the existing list file of a folder and flushes it to disk. Call it before the
/// file itself is created, so that no file exists that is not listed. Throws UserError when the
/// list is missing or cannot be written.
void add_to_file_list(const std::filesystem::path& folder, const std::string& name);

/// Replaces the list file of a folder by an empty list, or creates it. Throws UserError when it
/// cannot be written.
void clear_file_list(const std::filesystem::path& folder);

} // namespace ionskin::results
