// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

/// The name, or the name with a number, of which there is neither a folder nor a case file now.
/// Throws HttpError 400 as `Workspace::place`.
std::string free_name(const Workspace& workspace, const std::string& wanted);

/// A name for results that nobody else gets, however many ask for it at once: what bears it is
/// made, and goes again with this object unless it is kept.
class NewResults {
public:
  /// Makes the empty folder NAME.
  /// @param case_text that NAME.toml gets, or nothing for results of a case file that is there
  NewResults(const Workspace& workspace, const std::string& wanted, const std::string* case_text);
  ~NewResults();
  NewResults(const NewResults&) = delete;
  NewResults& operator=(const NewResults&) = delete;

  const std::string& name() const { return name_; }
  void keep() { kept_ = true; }

private:
  bool take(const std::string& name, bool with_case);
  void give_back();

  const Workspace& workspace_;
  std::string name_;
  bool has_folder_ = false, has_case_ = false, kept_ = false;
};

/// Writes a new file under a name that nobody else has and returns the name: NAME.csv, or
/// NAME-2.csv. Throws as `Workspace::place`, and UnwritableFile.
std::string write_new_file(const Workspace& workspace, const std::string& stem,
                           const std::string& extension, std::string_view text);

} // namespace ionskin::apps::studio
