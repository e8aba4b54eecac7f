// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

/// Options of `ionskin cite`.
struct CiteOptions {
  std::string path; ///< folder of a run, or a case file; empty for the methods of all cases
};

/// Runs `ionskin cite`: prints BibTeX entries of the program, of the article whose case it first
/// simulated, and of the methods that a run or a case uses. Returns the exit code 0. Throws
/// UserError when the path holds no case.
int cite(const CiteOptions& options);

} // namespace ionskin::apps
