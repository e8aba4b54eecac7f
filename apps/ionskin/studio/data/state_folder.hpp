// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::apps::studio {

/// Folder of the Studio's own records of a workspace, made if it is missing, in $XDG_STATE_HOME or
/// ~/.local/state. It lies outside the workspace, where only the user can write, because the Studio
/// runs the commands of the jobs recorded there without asking.
/// @param workspace canonical path of the workspace
/// Throws UserError when the folder cannot be made or others may write there.
std::filesystem::path state_folder(const std::filesystem::path& workspace);

} // namespace ionskin::apps::studio
