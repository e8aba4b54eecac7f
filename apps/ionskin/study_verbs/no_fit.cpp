// SPDX-License-Identifier: Apache-2.0

// This source stands in the place of fit.cpp where the packages that a fit needs are missing.

#include "study_verbs/fit.hpp"

#include "ionskin/base/error.hpp"

namespace ionskin::apps {

int fit(const FitOptions&, const std::string&) {
  throw UserError("fit: this build has none, for libceres-dev was missing when it was configured\n"
                  "  = make build installs it and builds every part");
}

} // namespace ionskin::apps
