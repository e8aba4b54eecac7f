// SPDX-License-Identifier: Apache-2.0

// Main program of the reading process of `ForeignHdf5File`. Its standard input is a socket to the
// client, its descriptor 3 is the file, and its argument the name of the file for messages.

#include "ionskin/results/hdf5/hdf5_service.hpp"

#include <unistd.h>

int main(int argc, char** argv) {
  constexpr int file = 3;
  // The process ends without clean-up, in which the library could crash after a damaged file.
  _exit(argc == 2 ? ionskin::results::serve_hdf5(STDIN_FILENO, file, argv[1]) : 1);
}
