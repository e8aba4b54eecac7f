// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// A page that leads to a link, and that only the user can read: every user of the computer sees
/// the words that a browser is started with. It is there as long as the object.
class LinkFile {
public:
  /// In XDG_RUNTIME_DIR, or else where temporary files lie. Throws std::system_error.
  explicit LinkFile(const std::string& link);
  ~LinkFile();
  LinkFile(const LinkFile&) = delete;
  LinkFile& operator=(const LinkFile&) = delete;

  std::filesystem::path path() const { return folder_ / "open.html"; }

private:
  std::filesystem::path folder_;
};

} // namespace ionskin::apps::studio
