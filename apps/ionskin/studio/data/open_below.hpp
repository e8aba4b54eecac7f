// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <filesystem>

namespace ionskin::apps::studio {

/// Opens what a name means below a folder, to be read, without following a link in any part of the
/// name and without waiting for a pipe's writer. What is checked of the descriptor holds for what
/// is read from it, whatever happens to the name meanwhile.
/// @return -1 with errno ELOOP for a link, EXDEV for a name that leads up or is absolute
base::FileDescriptor open_below(const base::FileDescriptor& folder,
                                const std::filesystem::path& name);

/// A name by which this process reaches what is open, until it is closed.
std::filesystem::path path_of(const base::FileDescriptor& open);

bool is_folder(const base::FileDescriptor& open);
/// An ordinary file: no folder, pipe, socket or device.
bool is_file(const base::FileDescriptor& open);

} // namespace ionskin::apps::studio
