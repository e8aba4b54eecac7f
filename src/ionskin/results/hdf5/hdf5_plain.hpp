// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/hdf5/hdf5_handle.hpp"

#include <filesystem>
#include <string>
#include <vector>

// The part of an HDF5 file that ionskin reads: objects that hard links lead to, and datasets that
// hold all their numbers or texts in the file itself, in pieces that memory can take. Links to
// elsewhere, raw data in other files, virtual datasets, values that were never written and filters
// that only plug-ins know are refused. Each function throws UserError naming the file, the object
// and the remedy.

namespace ionskin::results {

/// True if `object` exists. Throws when a link on the way is not a hard link.
bool has_plain(hid_t file, const std::filesystem::path& path, const std::string& object);

Hdf5Handle open_plain_dataset(hid_t file, const std::filesystem::path& path,
                              const std::string& object);
Hdf5Handle open_plain_group(hid_t file, const std::filesystem::path& path,
                            const std::string& object);
/// Names of the members of a group, in alphabetical order.
std::vector<std::string> plain_members(hid_t file, const std::filesystem::path& path,
                                       const std::string& group);

/// Opens every object of the file: what a library may stumble over shows now.
void require_plain_content(hid_t file, const std::filesystem::path& path);

/// The dataset with room for all pieces of one frame, so that none is decompressed twice.
Hdf5Handle open_plain_frames(hid_t file, const std::filesystem::path& path,
                             const std::string& object);

} // namespace ionskin::results
