// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::apps {

struct CiteOptions {
  std::string path; ///< folder of a run, or a case file; empty for the methods of all cases
};

/// Prints BibTeX of the program, of the article on its first case, and of the methods that a run
/// or a case uses. Throws UserError where the path holds no case.
int cite(const CiteOptions& options);

} // namespace ionskin::apps
