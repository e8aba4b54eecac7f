// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

/// Finds a name that neither a folder nor a case file of the workspace has now: `wanted`, or
/// `wanted` with a number. It may be taken by the time it is used. Throws HttpError 400 as
/// `Workspace::place`.
std::string free_name(const Workspace& workspace, const std::string& wanted);

/// New name for results, reserved by making an empty folder NAME and, if asked for, the case file
/// NAME.toml, so that two requests at once never get the same name. The destructor removes folder
/// and file again unless `keep` was called.
class NewResults {
public:
  /// Makes folder and case file under the first free name.
  /// @param wanted name to begin with; a number is appended where it is taken
  /// @param case_text text of the case file NAME.toml to write; null for results of a case file
  /// that exists already
  /// Throws HttpError 400 as `Workspace::place`, and UnwritableFile.
  NewResults(const Workspace& workspace, const std::string& wanted, const std::string* case_text);
  ~NewResults();
  NewResults(const NewResults&) = delete;
  NewResults& operator=(const NewResults&) = delete;

  const std::string& name() const { return name_; }
  /// Keeps folder and file when this object is destroyed.
  void keep() { kept_ = true; }

private:
  bool take(const std::string& name, bool with_case);
  void give_back();

  const Workspace& workspace_;
  std::string name_;
  bool has_folder_ = false, has_case_ = false, kept_ = false;
};

/// Writes a new file under the first free name, NAME.csv, NAME-2.csv, ..., and returns the name.
/// @param stem NAME without the extension
/// @param extension with its dot, such as ".csv"
/// Throws HttpError 400 as `Workspace::place`, and UnwritableFile.
std::string write_new_file(const Workspace& workspace, const std::string& stem,
                           const std::string& extension, std::string_view text);

} // namespace ionskin::apps::studio
