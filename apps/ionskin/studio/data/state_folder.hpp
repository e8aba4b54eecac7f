// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::apps::studio {

/// The folder of the Studio's own records of a workspace, made if it is missing: in
/// $XDG_STATE_HOME or ~/.local/state, where only the user writes, for the commands of its jobs are
/// run without a question.
/// @param workspace canonical
/// Throws UserError when it cannot be made or others may write there.
std::filesystem::path state_folder(const std::filesystem::path& workspace);

} // namespace ionskin::apps::studio
