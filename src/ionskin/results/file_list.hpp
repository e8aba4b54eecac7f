// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace ionskin::results {

/// Name of the list of the files that ionskin wrote into a folder, one name a line. The Python
/// package adds its figures, see output_folder.py.
inline constexpr const char* file_list_name = ".ionskin-files";

/// A name that leads nowhere but into the folder or a folder in it.
bool is_inner_name(const std::string& name);

/// The names in the list; anything but an inner name is left out. Empty when there is no list.
std::optional<std::set<std::string>> read_file_list(const std::filesystem::path& folder);

/// Adds a name to the list, which is made if it is missing, and flushes it to the disk, so that no
/// file exists before its name stands here. Throws UserError when it cannot.
void add_to_file_list(const std::filesystem::path& folder, const std::string& name);

/// Makes the list empty. Throws UserError when it cannot.
void clear_file_list(const std::filesystem::path& folder);

} // namespace ionskin::results
