// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::base {

/// A share as a reader sees it: "0.65 %", "130 %"; two significant digits. Beyond 1,000 % an error
/// only tells that nothing is known: "over 1000 %".
std::string percent(double share);

} // namespace ionskin::base
