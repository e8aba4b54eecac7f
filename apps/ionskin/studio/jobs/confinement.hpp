// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

namespace ionskin::apps::studio {

/// Confinement of a program that the Studio starts, by Linux's Landlock: the program can read the
/// system and ionskin itself, and can read and write in one folder only. The Studio checks files
/// before it names them to the program; without confinement, a link put in place of a checked file
/// would lead the program elsewhere.
class Confinement {
public:
  /// Prepares the rules.
  /// @param folder folder in which the program may read and write
  explicit Confinement(const base::FileDescriptor& folder);

  /// Confines this process, and all processes that it starts, for good. Safe between fork and exec.
  /// Returns false when the kernel refuses; true, without any effect, where the kernel has no
  /// Landlock.
  bool enter() const noexcept;

  /// True if the kernel can confine: from Linux 5.19 on, where Landlock is not switched off.
  static bool is_available() noexcept;

private:
  base::FileDescriptor rules_;
};

} // namespace ionskin::apps::studio
