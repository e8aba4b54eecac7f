// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::results {

/// Main loop of the reading process of `ForeignHdf5File`: answers questions about one HDF5 file
/// (hdf5_protocol.hpp) until the client closes its end. Before the HDF5 library sees the file, the
/// process limits itself, so that damage can do no harm: it may take at most 2 GB of further
/// memory, open no other file, and compute only as long as `reading_seconds` allows.
/// @param socket connected to the client process
/// @param file descriptor of the HDF5 file
/// @param name of the file in messages
/// @return exit code: 0 when the client has closed its end, else 1
int serve_hdf5(int socket, int file, const std::string& name);

} // namespace ionskin::results
