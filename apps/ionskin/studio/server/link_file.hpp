// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// File with an HTML page that leads to the one-time link, which only the user can read. A browser
/// is started with the name of this file, since every user of the computer can see the arguments of
/// a process. The destructor removes the file.
class LinkFile {
public:
  /// Writes the file in XDG_RUNTIME_DIR, or else in the folder of temporary files. Throws
  /// std::system_error.
  explicit LinkFile(const std::string& link);
  ~LinkFile();
  LinkFile(const LinkFile&) = delete;
  LinkFile& operator=(const LinkFile&) = delete;

  std::filesystem::path path() const { return folder_ / "open.html"; }

private:
  std::filesystem::path folder_;
};

} // namespace ionskin::apps::studio
