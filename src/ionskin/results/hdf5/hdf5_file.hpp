// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ionskin::results {

/// An open HDF5 file, with the few operations that the results need. An object (dataset or group)
/// is named by its path inside the file ("/strain/gamma"); writing creates missing groups on the
/// path. Numbers are doubles; integers are converted when read. HDF5 serves one thread at a time:
/// the thread that has a file open holds a lock, and other threads that open a file wait.
///
/// Use `ForeignHdf5File` for files that this process has not written itself. Objects that are read
/// must be plain, as hdf5_plain.hpp defines.
///
/// Errors: UserError when the file cannot be opened, is not an HDF5 file, lacks the object to be
/// read, or cannot be written; the message names the file and the object.
class Hdf5File {
public:
  enum class Access {
    create, ///< create a new file, or replace an existing one
    read,
    modify ///< read and write an existing file
  };
  using Shape = std::vector<std::size_t>; ///< lengths of the dimensions, slowest first

  Hdf5File(std::filesystem::path path, Access access);
  /// Opens a file image in memory for reading.
  /// @param image bytes of the file, which must outlive this object
  /// @param name of the file in messages
  Hdf5File(std::span<std::byte> image, std::filesystem::path name);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Flushes and closes the file. The destructor closes it too, but cannot report a failure.
  void close();

  /// True if `object` exists.
  bool has(const std::string& object) const;
  /// True if `object` exists and is a dataset of numbers.
  bool has_numbers(const std::string& object) const;
  /// Names of the members of a group, in alphabetical order.
  std::vector<std::string> members(const std::string& group) const;
  /// Lengths of the dimensions of a dataset; empty for a scalar.
  Shape shape(const std::string& dataset) const;
  /// Opens every object of the file, so that damage shows now rather than in a later read.
  void require_plain() const;
  /// Gives an object a second name (hard link).
  void link(const std::string& object, const std::string& name);
  /// Removes an object; does nothing if it does not exist.
  void remove(const std::string& object);

  /// Writes numbers as a new dataset.
  /// @param shape of the row-major `values`; empty for one dimension
  void write(const std::string& dataset, const std::vector<double>& values, Shape shape = {});
  void write(const std::string& dataset, const std::vector<int>& values);
  /// Writes numbers as a new dataset, with their unit in its attribute "unit".
  void write_with_unit(const std::string& dataset, const std::vector<double>& values,
                       const std::string& unit, const Shape& shape = {});
  /// Writes one UTF-8 text as a new scalar dataset.
  void write_text(const std::string& dataset, const std::string& text);
  /// Writes a list of UTF-8 texts as a new one-dimensional dataset.
  void write_texts(const std::string& dataset, const std::vector<std::string>& texts);
  /// Reads all values of a dataset of numbers, row-major.
  std::vector<double> read(const std::string& dataset) const;
  /// Reads a dataset that holds one text.
  std::string read_text(const std::string& dataset) const;
  /// Reads a one-dimensional dataset of texts of fixed length.
  std::vector<std::string> read_texts(const std::string& dataset) const;

  /// Creates a compressed dataset to be written frame by frame. A frame is all values at one index
  /// of the first dimension; the first entry of `shape` is the number of frames.
  void create_frames(const std::string& dataset, const Shape& shape);
  /// Writes one frame. Throws InternalError when `values` has not the size of a frame.
  /// @param values of the frame, row-major over the other dimensions
  void write_frame(const std::string& dataset, std::size_t frame,
                   const std::vector<double>& values);
  /// Copies the compressed bytes of the written frame `source` to `frame`, without compressing
  /// again.
  void repeat_frame(const std::string& dataset, std::size_t source, std::size_t frame);
  /// Reads one frame: all values at one index of the first dimension of a dataset.
  /// @param values receives the frame, row-major over the other dimensions; resized
  void read_frame(const std::string& dataset, std::size_t frame, std::vector<double>& values) const;

  /// Sets an attribute of a dataset or group; a missing object is created as a group. The object
  /// "/" is the root group.
  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, int value);
  /// Reads an attribute of an object. Nothing (`nullopt`) when the object or the attribute is
  /// missing, or the attribute has another type.
  std::optional<std::string> text_attribute(const std::string& object,
                                            const std::string& name) const;
  std::optional<double> number_attribute(const std::string& object, const std::string& name) const;

private:
  struct OpenFrames;

  std::unique_lock<std::recursive_mutex> library_; ///< lock on the HDF5 library, released last
  std::filesystem::path path_;
  std::int64_t id_ = -1;
  bool written_ = false;
  mutable std::unique_ptr<OpenFrames> frames_; ///< dataset of the last frame read, still open
};

} // namespace ionskin::results
