// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::results {

/// Answers questions about one HDF5 file until the other end closes: what the process apart does
/// for ForeignHdf5File. Before the library sees the file the process gives up what damage could
/// misuse: it may take 2 GB more memory than it has, open no file, and compute only as long as
/// `reading_seconds` allows.
/// @param socket to the process that asks
/// @param file descriptor of the HDF5 file, @param name its name in messages
/// @return exit code
int serve_hdf5(int socket, int file, const std::string& name);

} // namespace ionskin::results
