// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::apps::studio {

/// Runs the command of a job to its end and writes its exit code into end.json. It is the main
/// function of a separate process, `ionskin-studio --keep FOLDER`, so that the server may end and
/// start again while the job runs.
/// @param folder folder of the job among the Studio's records
/// @return 0, whatever the command's exit code
int keep_job(const std::filesystem::path& folder);

} // namespace ionskin::apps::studio
