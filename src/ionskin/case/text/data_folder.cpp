// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/data_folder.hpp"

#include "ionskin/base/system/installation.hpp"

#include <cstdlib>

namespace ionskin {

std::filesystem::path data_folder() {
  const char* folder = std::getenv("IONSKIN_DATA");
  return folder != nullptr && *folder != '\0' ? folder : base::installation().data;
}

} // namespace ionskin
