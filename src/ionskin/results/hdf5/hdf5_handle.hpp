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

/// Reason (errno) of the first object that this thread could not close, until it closes a file.
/// Closing a dataset writes what its cache still holds: where that fails, values are lost, and
/// closing the file does not tell.
inline thread_local std::optional<int> failed_close;

/// Owns one HDF5 identifier; throws UserError with `message` when HDF5 did not give one.
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

/// A message with the reason that the system gave for a failed write, if it did, before its remedy.
inline std::string with_reason(std::string message, int reason) {
  for (const int known : {ENOSPC, EFBIG, EDQUOT, EIO, EROFS}) {
    if (reason == known) {
      message.insert(std::min(message.find('\n'), message.size()),
                     std::string(": ") + std::strerror(reason));
    }
  }
  return message;
}

/// Throws UserError with `message` when an HDF5 call failed.
inline void require_hdf5(herr_t status, const std::string& message) {
  if (status < 0) {
    throw UserError(with_reason(message, errno));
  }
}

/// Link properties under which the groups on the way to a new object are made.
inline Hdf5Handle group_making_links() {
  const hid_t properties = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(properties, 1);
  return {properties, H5Pclose, "HDF5 lacks link properties"};
}

} // namespace ionskin::results
