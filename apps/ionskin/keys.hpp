// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

struct KeysOptions {
  bool json = false;
};

/// Prints every key of a case: what it is, its unit, range, default and source.
int keys(const KeysOptions& options);

} // namespace ionskin::apps
