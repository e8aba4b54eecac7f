// SPDX-License-Identifier: Apache-2.0

// Any bytes are a height map or are refused with a UserError.

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/height_map_file.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ionskin::fuzz::ScratchFile file(data, size);
  try {
    ionskin::read_height_map(file.path());
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
