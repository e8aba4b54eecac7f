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

/// Reader of the fields in results.h5 of run folders, for the page. The files may come from
/// anybody, so a separate process reads them. The file that was asked for last stays open, since a
/// page that plays a field asks for one instant after another. May be called from several threads;
/// one call is served at a time.
class FieldData {
public:
  /// Identity of a file, by which a changed file is noticed: device, inode number, size [bytes],
  /// and time of the last change [s] and [ns].
  using Version = std::array<long long, 5>;

  /// Lists the fields that results.h5 holds, with their grids and instants: {"ions": {"x", "y",
  /// "z", "frames": [{"name", "time", "fields"}]}, "strain": {"x", "y", "z", "time", "frame",
  /// "slider_x", "slider_y"}, "contact": {"x", "y", "frames": [{"name", "time", "fields"}]}}; null
  /// in place of a group that the file lacks. Lengths [m] are measured from the skin's corner and
  /// the core's bottom, or in x and y from the slider's centre; times in [s].
  /// Throws UserError when the file is damaged.
  Json list(const Opened& results);

  /// Returns one field at one instant as a packed message, see `packed`, of 32-bit floats, in which
  /// x varies fastest, then y, then z; the heading is {"shape", "unit", "least", "greatest"}.
  /// @param group "ions", "strain" or "contact"
  /// @param frame name of the instant; for the strain its index from 0
  /// @param name name of the field; the strain has one field only
  /// Throws HttpError 404 when there is no such field, 413 when it is too large for a page;
  /// UserError when the file is damaged.
  std::string packed(const Opened& results, const std::string& group, const std::string& frame,
                     const std::string& name);

private:
  /// Opens the file, unless it is open already, and returns `read(file)`. A file that could not be
  /// read is closed.
  template <class Read> auto with(const Opened& results, const Read& read);

  std::mutex mutex_;
  /// File that was asked for last; null before the first.
  std::unique_ptr<results::ForeignHdf5File> file_;
  Version version_;
};

} // namespace ionskin::apps::studio
