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

/// One HDF5 file with the few operations the results need. Objects are named by their path inside
/// the file ("/strain/gamma"); groups on the way are made when writing. Numbers are doubles,
/// integers are converted on reading. HDF5 serves one thread at a time: while a file is open, its
/// thread holds a lock, and other threads wait for it when they open one.
///
/// Files that this process has not written itself are read through ForeignHdf5File. What is read
/// must be plain: see hdf5_plain.hpp.
///
/// Errors: UserError when the file cannot be opened, is not an HDF5 file, lacks what is read or
/// cannot be written; the message names the file and the object.
class Hdf5File {
public:
  enum class Access {
    create, ///< a new file; an old one is replaced
    read,
    modify ///< an existing file
  };
  using Shape = std::vector<std::size_t>;

  Hdf5File(std::filesystem::path path, Access access);
  /// Reads a file whose bytes are in memory already and stay there.
  /// @param name under which messages know it
  Hdf5File(std::span<std::byte> image, std::filesystem::path name);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes everything out. Called by the destructor too, which cannot report failure.
  void close();

  bool has(const std::string& object) const;
  /// True when `object` exists and is a dataset of numbers.
  bool has_numbers(const std::string& object) const;
  /// Names of the members of a group, in alphabetical order.
  std::vector<std::string> members(const std::string& group) const;
  Shape shape(const std::string& dataset) const;
  /// Opens every object: damage that the library finds, or stumbles over, shows now.
  void require_plain() const;
  /// Gives an object a second name.
  void link(const std::string& object, const std::string& name);
  /// Removes an object if it is there.
  void remove(const std::string& object);

  /// Writes numbers as a new dataset.
  /// @param shape of row-major `values`; empty for one dimension
  void write(const std::string& dataset, const std::vector<double>& values, Shape shape = {});
  void write(const std::string& dataset, const std::vector<int>& values);
  /// Writes as `write` does; the attribute "unit" tells the unit of the values.
  void write_with_unit(const std::string& dataset, const std::vector<double>& values,
                       const std::string& unit, const Shape& shape = {});
  void write_text(const std::string& dataset, const std::string& text);
  void write_texts(const std::string& dataset, const std::vector<std::string>& texts);
  std::vector<double> read(const std::string& dataset) const;
  std::string read_text(const std::string& dataset) const;
  std::vector<std::string> read_texts(const std::string& dataset) const;

  /// A compressed dataset that is written frame by frame; the first entry of `shape` counts frames.
  void create_frames(const std::string& dataset, const Shape& shape);
  void write_frame(const std::string& dataset, std::size_t frame,
                   const std::vector<double>& values);
  /// Writes the compressed bytes of an earlier frame again.
  void repeat_frame(const std::string& dataset, std::size_t source, std::size_t frame);
  /// Reads one frame of a dataset of frames.
  /// @param values is resized to one frame
  void read_frame(const std::string& dataset, std::size_t frame, std::vector<double>& values) const;

  /// Attributes of a dataset or of a group, which is made if it is missing; "/" is the file.
  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, int value);
  /// Empty when the attribute is missing or of another type.
  std::optional<std::string> text_attribute(const std::string& object,
                                            const std::string& name) const;
  std::optional<double> number_attribute(const std::string& object, const std::string& name) const;

private:
  struct OpenFrames;

  std::unique_lock<std::recursive_mutex> library_; ///< released last
  std::filesystem::path path_;
  std::int64_t id_ = -1;
  bool written_ = false;
  mutable std::unique_ptr<OpenFrames> frames_; ///< of which the last frame was read
};

} // namespace ionskin::results
