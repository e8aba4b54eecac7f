// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::apps::studio {

/// Runs the command of a job to its end and writes end.json. It is a process of its own, so that
/// the server may go and come back meanwhile: `ionskin-studio --keep FOLDER`.
/// @param folder of the job among the Studio's records
int keep_job(const std::filesystem::path& folder);

} // namespace ionskin::apps::studio
