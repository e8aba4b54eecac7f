// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace ionskin::readout {

/// Suffix of the names of signals, quantities and files that belong to one of several sliders:
/// empty for the first slider, "_2" for the second.
/// @param slider index in the list of the case, from 0
inline std::string slider_suffix(std::size_t slider) {
  return slider == 0 ? "" : "_" + std::to_string(slider + 1);
}

} // namespace ionskin::readout
