// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin {

/// A case file in a folder of its own, removed at the end.
class TemporaryCase {
public:
  explicit TemporaryCase(const std::string& text);
  ~TemporaryCase();
  TemporaryCase(const TemporaryCase&) = delete;
  TemporaryCase& operator=(const TemporaryCase&) = delete;

  /// "<folder>/case.toml"
  std::string path() const { return folder_ + "/case.toml"; }
  const std::string& folder() const { return folder_; }

private:
  std::string folder_;
};

/// A valid case, with one span of its text replaced. Fails when the span is not there.
std::string valid_case(const std::string& replace = "", const std::string& with = "");

/// Message of the UserError that reading this text throws, or empty when it is accepted.
std::string error_of(const std::string& text);

} // namespace ionskin
