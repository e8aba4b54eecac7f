// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_reader_image.hpp"

// IONSKIN_HDF5_READER is the path of the reader executable, which is built before this file.
asm(".pushsection .rodata\n"
    ".balign 16\n"
    "ionskin_hdf5_reader_begin:\n"
    ".incbin \"" IONSKIN_HDF5_READER "\"\n"
    "ionskin_hdf5_reader_end:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" const char ionskin_hdf5_reader_begin[], ionskin_hdf5_reader_end[];

namespace ionskin::results {

std::string_view hdf5_reader_image() {
  return {ionskin_hdf5_reader_begin,
          static_cast<std::size_t>(ionskin_hdf5_reader_end - ionskin_hdf5_reader_begin)};
}

} // namespace ionskin::results
