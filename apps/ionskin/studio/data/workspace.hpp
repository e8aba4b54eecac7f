// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/open_below.hpp"

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Where a workspace brings records of jobs along, such as those of earlier versions.
inline constexpr const char* brought_records = ".studio";

/// A file or folder of the workspace, open to be read.
struct Opened {
  base::FileDescriptor file;
  std::string name; ///< as pages and commands name it: relative, "." for the workspace itself
};

/// The name of what lies in a folder of the workspace: "./-a" and not "-a", which a program would
/// take for an option.
std::string name_below(const std::string& folder, const std::string& name);

/// The folder that the Studio works in. Every path of a request goes through `open`.
class Workspace {
public:
  /// Makes the folder if it is missing. Throws UserError when it cannot be used, or when another
  /// Studio of this user works in it.
  explicit Workspace(const std::filesystem::path& folder);

  const std::filesystem::path& root() const { return root_; }
  const base::FileDescriptor& folder() const { return folder_; }
  /// The folder of the Studio's own records, where nobody but the user writes.
  const std::filesystem::path& state() const { return state_; }

  /// File that a request names relative to the workspace. Links are not followed. Throws HttpError:
  /// 403 when it lies outside or among the Studio's own records or is a link, 404 when it is not
  /// there.
  Opened open(const std::string& relative) const;

  /// A place for a new file or folder of this name. Throws HttpError 400 for names that are no
  /// plain file names.
  std::filesystem::path place(const std::string& name) const;

private:
  std::filesystem::path root_, state_;
  base::FileDescriptor folder_, lock_;
};

} // namespace ionskin::apps::studio
