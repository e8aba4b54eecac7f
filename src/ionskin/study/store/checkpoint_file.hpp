// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/ion_transport.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes where Study 2 stands, so that a resumed run goes on with the same result bit for bit.
/// The file is sealed.
/// @param input_hash of the case and the strain that it belongs to
void write_checkpoint(const std::filesystem::path& path, const std::string& input_hash,
                      const electrochemistry::IonCheckpoint& checkpoint);

/// Reads a checkpoint back; empty when there is none, when it is damaged or of another build, or
/// when it belongs to another case.
std::optional<electrochemistry::IonCheckpoint> read_checkpoint(const std::filesystem::path& path,
                                                               const std::string& input_hash);

} // namespace ionskin::study
