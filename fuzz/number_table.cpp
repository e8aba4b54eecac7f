// SPDX-License-Identifier: Apache-2.0

// Any bytes are a recording or are refused with a UserError.

#include "ionskin/case/text/number_table.hpp"
#include "ionskin/base/error.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ionskin::fuzz::ScratchFile file(data, size);
  try {
    ionskin::read_number_table(file.path(), "recording");
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
