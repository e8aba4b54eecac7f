// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <filesystem>

namespace ionskin::apps::studio {

/// Opens a file or folder below a folder for reading, without following a link in any part of the
/// name and without waiting for a pipe's writer. Callers check the descriptor, not the name, since
/// the name may mean another file a moment later.
/// @param name relative name
/// @return invalid descriptor (-1) on failure, with errno: ELOOP for a link, EXDEV for a name that
/// is absolute or contains ".."
base::FileDescriptor open_below(const base::FileDescriptor& folder,
                                const std::filesystem::path& name);

/// Path by which this process reaches an open file, for libraries that take names; valid until the
/// descriptor is closed.
std::filesystem::path path_of(const base::FileDescriptor& open);

/// True if the descriptor is that of a folder.
bool is_folder(const base::FileDescriptor& open);
/// True if the descriptor is that of an ordinary file: no folder, pipe, socket or device.
bool is_file(const base::FileDescriptor& open);

} // namespace ionskin::apps::studio
