// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::base {

/// Formats a ratio [1] as a percentage with two significant digits: "0.65 %", "130 %". Values above
/// 10 become "over 1000 %", since such an error only says that nothing is known.
std::string percent(double share);

} // namespace ionskin::base
