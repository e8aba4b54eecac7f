// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/ion_transport.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes the state of Study 2 (ion transport) into a sealed file, so that a resumed run goes on
/// with identical results bit for bit.
/// @param input_hash of the case and the strain history that the state belongs to
void write_checkpoint(const std::filesystem::path& path, const std::string& input_hash,
                      const electrochemistry::IonCheckpoint& checkpoint);

/// Reads a checkpoint of Study 2. Empty when the file is missing, damaged, of another build of the
/// program, or of another case.
/// @param input_hash of the case and the strain history, as given to `write_checkpoint`
std::optional<electrochemistry::IonCheckpoint> read_checkpoint(const std::filesystem::path& path,
                                                               const std::string& input_hash);

} // namespace ionskin::study
