// SPDX-License-Identifier: Apache-2.0

// The process that reads for ForeignHdf5File: its standard input is a socket, descriptor 3 the
// file.

#include "ionskin/results/hdf5/hdf5_service.hpp"

#include <unistd.h>

int main(int argc, char** argv) {
  constexpr int file = 3;
  // The process ends at once: what a damaged file has left of the library is not worth tidying.
  _exit(argc == 2 ? ionskin::results::serve_hdf5(STDIN_FILENO, file, argv[1]) : 1);
}
