// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::apps {

/// Prints how to cite the program, as text and for BibTeX.
int cite();

} // namespace ionskin::apps
