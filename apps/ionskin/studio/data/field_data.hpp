// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "studio/data/workspace.hpp"
#include "studio/server/json.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <string>

namespace ionskin::apps::studio {

/// Fields of the results.h5 in run folders, which may come from anybody: a process apart reads
/// them. It keeps the file that was asked for last, since a page that plays asks for one instant
/// after the other. For several threads; one is served at a time.
class FieldData {
public:
  /// Device, number, size and time of change of a file, which tell whether it is the same.
  using Version = std::array<long long, 5>;

  /// List of the fields that results.h5 holds, with their grids and instants: {"ions": {"x", "y",
  /// "z", "frames":
  /// [{"name", "time", "fields"}]}, "strain": {"x", "y", "z", "time", "frame", "slider_x",
  /// "slider_y"}, "contact":
  /// {"x", "y", "frames": [{"name", "time"}]}}; each null when there is none. Lengths in m, from
  /// the skin's corner and the core's bottom, or from the slider's centre.
  Json list(const Opened& results);

  /// One field at one instant as a packed message of 32-bit floats, x fastest, then y, then z: the
  /// heading {"shape", "unit", "least", "greatest"}.
  /// @param group "ions", "strain" or "contact"
  /// @param frame name of the instant; for strain its number
  /// Throws HttpError 404 when it is not there, 413 when it is too large for a page.
  std::string packed(const Opened& results, const std::string& group, const std::string& frame,
                     const std::string& name);

private:
  /// Calls `read` with the opened file; one that failed is not kept.
  template <class Read> auto with(const Opened& results, const Read& read);

  std::mutex mutex_;
  std::unique_ptr<results::ForeignHdf5File> file_;
  Version version_;
};

} // namespace ionskin::apps::studio
