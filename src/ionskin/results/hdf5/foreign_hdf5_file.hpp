// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/file_copy.hpp"
#include "ionskin/base/system/child_program.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_protocol.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::results {

/// Reader of an HDF5 file that is not trusted: a user supplied it, or someone may have changed it
/// since it was written. The HDF5 library can crash or loop forever on damaged files, so a separate
/// process with bounded memory and time reads the file, and only names, texts and numbers come
/// back. The member functions return the same as those of `Hdf5File`; values stored in other files
/// are refused.
///
/// Errors: UserError naming the file and the object, as for `Hdf5File`; also when the file is not a
/// regular file, damage crashes the library or keeps it busy without end, or an array is larger
/// than half of the available memory (checked before any of it is read).
class ForeignHdf5File {
public:
  using Shape = Hdf5File::Shape;

  /// Copies the file into memory and starts the process that reads the copy.
  explicit ForeignHdf5File(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  /// Digest of the bytes of the copy, from which all values are read.
  const base::Digest& digest() const { return copy_.digest(); }

  bool has(const std::string& object) const;
  bool has_numbers(const std::string& object) const;
  std::vector<std::string> members(const std::string& group) const;
  Shape shape(const std::string& dataset) const;
  /// Opens every object of the file, to find damage of its structure before the file is written to.
  void require_plain() const;
  std::vector<double> read(const std::string& dataset) const;
  std::string read_text(const std::string& dataset) const;
  std::vector<std::string> read_texts(const std::string& dataset) const;
  /// Reads one frame: all values at one index of the first dimension of a dataset.
  /// @param values receives the frame, row-major over the other dimensions; resized
  void read_frame(const std::string& dataset, std::size_t frame, std::vector<double>& values) const;
  std::optional<std::string> text_attribute(const std::string& object,
                                            const std::string& name) const;
  std::optional<double> number_attribute(const std::string& object, const std::string& name) const;

private:
  /// Sends a question to the reading process and receives the header of its answer. Returns the
  /// size of the content, to be received next [bytes]; nothing (`nullopt`) when an attribute does
  /// not exist.
  std::optional<std::uint64_t> ask(Hdf5Question question, const std::string& object,
                                   const std::string& name = "", std::uint64_t expected_bytes = 0,
                                   std::uint64_t frame = 0) const;
  void receive(void* bytes, std::size_t count) const;
  void receive_numbers(std::uint64_t bytes, const std::string& object,
                       std::vector<double>& values) const;
  std::string receive_text(std::uint64_t bytes, const std::string& object) const;
  bool receive_truth(std::uint64_t bytes, const std::string& object) const;
  void require_memory(double bytes, const std::string& object) const;
  [[noreturn]] void lost(base::ChildProgram::Transfer how) const;
  [[noreturn]] void contradicted(const std::string& object) const;

  std::filesystem::path path_;
  base::FileCopy copy_;
  mutable base::ChildProgram reader_;
  mutable double seconds_ = 0; ///< time limit of the current answer [s]
};

} // namespace ionskin::results
