// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace ionskin::results {

/// Error number (errno) of the first HDF5 object that this thread failed to close; reset when the
/// thread closes a file. Closing a dataset writes its cached values: if that fails, values are
/// lost, and closing the file does not report it.
inline thread_local std::optional<int> failed_close;

/// Owner of one HDF5 identifier, which it closes with `closer`. The constructor throws UserError
/// with `message` when the identifier is negative: the HDF5 call that made it failed.
class Hdf5Handle {
public:
  using Closer = herr_t (*)(hid_t);

  Hdf5Handle(hid_t id, Closer closer, const std::string& message) : id_(id), closer_(closer) {
    if (id_ < 0) {
      throw UserError(message);
    }
  }
  ~Hdf5Handle() {
    if (id_ >= 0 && closer_(id_) < 0 && !failed_close) {
      failed_close = errno;
    }
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  Closer closer_;
};

/// Inserts the system's reason for a failed write into a message, at the end of its first line.
/// Only reasons of the disk are named (full, quota, read-only, too large, input/output error).
/// @param reason errno after the failed call
inline std::string with_reason(std::string message, int reason) {
  for (const int known : {ENOSPC, EFBIG, EDQUOT, EIO, EROFS}) {
    if (reason == known) {
      message.insert(std::min(message.find('\n'), message.size()),
                     std::string(": ") + std::strerror(reason));
    }
  }
  return message;
}

/// Throws UserError with `message` and the system's reason when an HDF5 call failed.
inline void require_hdf5(herr_t status, const std::string& message) {
  if (status < 0) {
    throw UserError(with_reason(message, errno));
  }
}

/// Link creation properties with which HDF5 creates missing groups on the path to a new object.
inline Hdf5Handle group_making_links() {
  const hid_t properties = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(properties, 1);
  return {properties, H5Pclose, "HDF5 lacks link properties"};
}

} // namespace ionskin::results
