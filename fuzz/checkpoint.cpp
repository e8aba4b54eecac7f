// SPDX-License-Identifier: Apache-2.0

// Any bytes are a checkpoint of this case, none of it, or are refused with a UserError.

#include "ionskin/base/error.hpp"
#include "ionskin/study/store/checkpoint_file.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ionskin::fuzz::ScratchFile file(data, size);
  try {
    ionskin::study::read_checkpoint(file.path(), "fuzz");
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
