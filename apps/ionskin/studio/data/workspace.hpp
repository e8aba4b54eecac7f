// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/open_below.hpp"

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Folder of a workspace in which records of jobs may have come along with it, such as those of
/// earlier versions.
inline constexpr const char* brought_records = ".studio";

/// File or folder of the workspace, open for reading.
struct Opened {
  base::FileDescriptor file;
  std::string name; ///< name relative to the workspace, as pages and commands use it; "." for the
                    ///< workspace itself
};

/// Name, relative to the workspace, of a file or folder `name` in its folder `folder`: "./-a" and
/// not "-a", which a program would take for an option.
std::string name_below(const std::string& folder, const std::string& name);

/// Folder in which the Studio works, with the user's cases and results. Every path that a request
/// names is opened by `open`.
class Workspace {
public:
  /// Makes the folder if it is missing. Throws UserError when it cannot be used, or when another
  /// Studio of this user works in it.
  explicit Workspace(const std::filesystem::path& folder);

  /// Canonical path of the workspace.
  const std::filesystem::path& root() const { return root_; }
  /// The workspace, open for reading.
  const base::FileDescriptor& folder() const { return folder_; }
  /// Folder of the Studio's own records, in which only the user can write, see `state_folder`.
  const std::filesystem::path& state() const { return state_; }

  /// Opens a file or folder that a request names relative to the workspace. Links are not followed.
  /// Throws HttpError: 403 for a name outside the workspace or among the Studio's own records, and
  /// for a link; 404 when there is no such file.
  Opened open(const std::string& relative) const;

  /// Path for a new file or folder of this name in the workspace; makes nothing. Throws HttpError
  /// 400 for names other than plain file names of at most 80 letters, digits, '-', '_' and '.'.
  std::filesystem::path place(const std::string& name) const;

private:
  std::filesystem::path root_, state_;
  base::FileDescriptor folder_, lock_;
};

} // namespace ionskin::apps::studio
