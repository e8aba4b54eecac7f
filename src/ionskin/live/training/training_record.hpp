// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/training/stated_errors.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <filesystem>
#include <string>

namespace ionskin::live {

/// Finished part of a training, from which an interrupted one is resumed with identical results bit
/// for bit.
struct TrainingRecord {
  SkinData data;             ///< the trained model, still without errors
  mesh::Footprint footprint; ///< rectangle in which the slider touches in the training
  ComparedTouches compared;  ///< errors on the validation touches so far
};

/// Writes a record, under a temporary name, then renames it. Throws base::UnwritableFile.
/// @param identity of everything that decides the result
void write_record(const std::filesystem::path& path, const std::string& identity,
                  const TrainingRecord& record);

/// Reads a record. Throws UserError when the file cannot be read, is damaged, or is of another
/// identity.
TrainingRecord read_record(const std::filesystem::path& path, const std::string& identity);

} // namespace ionskin::live
