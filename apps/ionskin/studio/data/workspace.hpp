// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// The folder that the Studio works in. Every path of a request goes through `inside`.
class Workspace {
public:
  /// Makes the folder if it is missing. Throws UserError when it cannot be used, or when another
  /// Studio works in it.
  explicit Workspace(const std::filesystem::path& folder);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  const std::filesystem::path& root() const { return root_; }
  /// The folder of the Studio's own records.
  std::filesystem::path state() const { return root_ / ".studio"; }

  /// The file or folder that a request names relative to the workspace, with every link followed.
  /// Throws HttpError: 403 when it lies outside or in the Studio's own records, 404 when it is not
  /// there.
  std::filesystem::path inside(const std::string& relative) const;
  /// As pages name it: relative, "." for the workspace itself.
  std::string relative(const std::filesystem::path& path) const;

  /// A place for a new file or folder of this name. Throws HttpError 400 for names that are no
  /// plain file names.
  std::filesystem::path place(const std::string& name) const;
  /// The name, or the name with a number, of which there is neither a folder nor a case file.
  std::string free_name(const std::string& wanted) const;

private:
  std::filesystem::path root_;
  int lock_ = -1;
};

/// A plain file name made from a title: "One quick touch!" becomes "one-quick-touch".
std::string plain_name(const std::string& title);

} // namespace ionskin::apps::studio
