// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/hdf5/hdf5_handle.hpp"

#include <filesystem>
#include <string>
#include <vector>

// The subset of HDF5 that ionskin reads ("plain"): objects reached through hard links only, and
// datasets that hold all their numbers or texts in the file itself, in chunks that fit into memory.
// Soft and external links, raw data in other files, virtual datasets, values that were never
// written, and filters that need plug-ins are refused. Each function throws UserError naming the
// file, the object and the remedy. In all of them `file` is the open file and `path` its name for
// messages.

namespace ionskin::results {

/// True if `object` exists. Throws UserError when a link on its path is not a hard link.
bool has_plain(hid_t file, const std::filesystem::path& path, const std::string& object);

/// Opens a dataset. Throws UserError when it does not exist or is not plain.
Hdf5Handle open_plain_dataset(hid_t file, const std::filesystem::path& path,
                              const std::string& object);
/// Opens a group. Throws UserError when it does not exist or is not plain.
Hdf5Handle open_plain_group(hid_t file, const std::filesystem::path& path,
                            const std::string& object);
/// Names of the members of a group, in alphabetical order.
std::vector<std::string> plain_members(hid_t file, const std::filesystem::path& path,
                                       const std::string& group);

/// Opens every object of the file, so that damage or content that is not plain shows now.
void require_plain_content(hid_t file, const std::filesystem::path& path);

/// Opens a dataset to be read frame by frame, with a chunk cache large enough for all chunks of one
/// frame, so that no chunk is decompressed twice.
Hdf5Handle open_plain_frames(hid_t file, const std::filesystem::path& path,
                             const std::string& object);

} // namespace ionskin::results
