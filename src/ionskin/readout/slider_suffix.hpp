// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace ionskin::readout {

/// End of the names of what belongs to one slider of several, in signals, figures and files: none
/// for the first, "_2" for the second.
/// @param slider place in the list of the case, from 0
inline std::string slider_suffix(std::size_t slider) {
  return slider == 0 ? "" : "_" + std::to_string(slider + 1);
}

} // namespace ionskin::readout
