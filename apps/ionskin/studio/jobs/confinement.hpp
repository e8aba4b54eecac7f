// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

namespace ionskin::apps::studio {

/// Rules, by the kernel's Landlock, for what a program that the Studio starts may reach: it reads
/// the system and ionskin itself, and reads and writes in one folder. It opens files by their
/// names, so a link that is put in place of what the Studio looked at would lead it anywhere else.
class Confinement {
public:
  explicit Confinement(const base::FileDescriptor& folder);

  /// Confines this process and all that it starts, for good. Safe between fork and exec. False when
  /// the kernel refuses; true without doing anything where it has no Landlock.
  bool enter() const noexcept;

  /// True if the kernel can do it: from Linux 5.19 on, where Landlock is not switched off.
  static bool is_available() noexcept;

private:
  base::FileDescriptor rules_;
};

} // namespace ionskin::apps::studio
