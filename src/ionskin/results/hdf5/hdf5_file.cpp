// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include "ionskin/results/hdf5/hdf5_handle.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/hdf5/hdf5_open_frames.hpp"
#include "ionskin/results/hdf5/hdf5_plain.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <hdf5_hl.h>
#include <new>
#include <string_view>
#include <utility>

namespace ionskin::results {
namespace {

[[noreturn]] void refuse_content(const std::filesystem::path& path) {
  throw UserError(fmt::format("{} is not an HDF5 file\n  = write it with h5py or another HDF5 "
                              "library, or check that its copy is complete",
                              path.string()));
}

void require_readable(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw UserError(
        fmt::format("{} is a folder, not an HDF5 file\n  = name a file in it", path.string()));
  }
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    throw UserError(
        fmt::format("{} is a pipe or a device, not an HDF5 file\n  = name a file", path.string()));
  }
  if (!std::ifstream(path)) {
    throw UserError(
        fmt::format("the file {} cannot be read: {}\n  = check its name and its permissions",
                    path.string(), std::strerror(errno)));
  }
  if (H5Fis_hdf5(path.c_str()) <= 0) {
    refuse_content(path);
  }
}

/// Throws std::bad_alloc when there is too little memory for the cache of a file, because the HDF5
/// library crashes in that case.
void require_cache_memory() {
  constexpr std::size_t cache_bytes = 1u << 20;
  void* volatile room = std::malloc(cache_bytes);
  if (room == nullptr) {
    throw std::bad_alloc();
  }
  std::free(room);
}

hid_t open_file(const std::filesystem::path& path, Hdf5File::Access access) {
  require_cache_memory();
  if (access == Hdf5File::Access::create) {
    return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  }
  require_readable(path);
  const bool read_only = access == Hdf5File::Access::read;
  return H5Fopen(path.c_str(), read_only ? H5F_ACC_RDONLY : H5F_ACC_RDWR, H5P_DEFAULT);
}

/// True if the bytes have the HDF5 signature, at the start or behind a user block of 512, 1024,
/// 2048, ... bytes.
bool has_signature(std::span<std::byte> image) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  const std::string_view bytes(reinterpret_cast<const char*>(image.data()), image.size());
  for (std::size_t place = 0; place < bytes.size(); place = place == 0 ? 512 : 2 * place) {
    if (bytes.substr(place).starts_with(signature)) {
      return true;
    }
  }
  return false;
}

std::vector<hsize_t> extents(const Hdf5File::Shape& shape) {
  return {shape.begin(), shape.end()};
}

Hdf5Handle simple_space(const Hdf5File::Shape& shape) {
  const std::vector<hsize_t> size = extents(shape);
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose,
          "HDF5 refuses the shape of an array"};
}

std::recursive_mutex& library_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

} // namespace

Hdf5File::Hdf5File(std::filesystem::path path, Access access)
    : library_(library_mutex()), path_(std::move(path)), written_(access != Access::read) {
  // Without its exit handler the library does not try again, at the end of the program, to write
  // data that did not fit on a full disk, which would crash. Every file is closed by this class.
  static const herr_t once = H5dont_atexit();
  static_cast<void>(once);
  // Turns off HDF5's stack traces, which would hide the messages of this class.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  id_ = open_file(path_, access);
  if (id_ < 0) {
    throw UserError(fmt::format("HDF5 cannot open {}\n  = check that the folder exists, that it is "
                                "writable and that no other program has the file open",
                                path_.string()));
  }
}

Hdf5File::Hdf5File(std::span<std::byte> image, std::filesystem::path name)
    : library_(library_mutex()), path_(std::move(name)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  if (!has_signature(image)) {
    refuse_content(path_);
  }
  id_ = H5LTopen_file_image(image.data(), image.size(),
                            H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE);
  if (id_ < 0) {
    throw UserError(read_failure(path_, "the content"));
  }
}

Hdf5File::~Hdf5File() {
  frames_.reset();
  if (id_ >= 0) {
    H5Fclose(id_);
    if (written_) {
      failed_close.reset(); // the file was not closed by `close`, so it is discarded
    }
  }
}

void Hdf5File::close() {
  frames_.reset();
  const auto lost = std::exchange(failed_close, std::nullopt);
  const hid_t id = id_;
  id_ = -1;
  const bool flushed = id < 0 || H5Fflush(id, H5F_SCOPE_LOCAL) >= 0;
  int reason = flushed ? 0 : errno;
  const bool closed = id < 0 || H5Fclose(id) >= 0;
  reason = flushed && !closed ? errno : reason;
  if (!flushed || !closed) {
    throw UserError(with_reason(write_failure(path_, "its last part"), reason));
  }
  if (lost) {
    throw UserError(with_reason(write_failure(path_, "a part of it"), *lost));
  }
}

bool Hdf5File::has(const std::string& object) const {
  return has_plain(id_, path_, object);
}

bool Hdf5File::has_numbers(const std::string& object) const {
  if (!has(object)) {
    return false;
  }
  const Hdf5Handle owner(H5Oopen(id_, object.c_str(), H5P_DEFAULT), H5Oclose,
                         read_failure(path_, object));
  if (H5Iget_type(owner) != H5I_DATASET) {
    return false;
  }
  const Hdf5Handle type(H5Dget_type(owner), H5Tclose, read_failure(path_, object));
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  return plain_members(id_, path_, group);
}

void Hdf5File::require_plain() const {
  require_plain_content(id_, path_);
}

Hdf5File::Shape Hdf5File::shape(const std::string& dataset) const {
  if (!has(dataset)) {
    throw UserError(missing_object(path_, dataset));
  }
  const Hdf5Handle owner(H5Dopen2(id_, dataset.c_str(), H5P_DEFAULT), H5Dclose,
                         missing_object(path_, dataset));
  const Hdf5Handle space(H5Dget_space(owner), H5Sclose, read_failure(path_, dataset));
  const int dimensions = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> size(static_cast<std::size_t>(std::max(dimensions, 0)));
  H5Sget_simple_extent_dims(space, size.data(), nullptr);
  return {size.begin(), size.end()};
}

void Hdf5File::link(const std::string& object, const std::string& name) {
  const Hdf5Handle links = group_making_links();
  require_hdf5(H5Lcreate_hard(id_, object.c_str(), id_, name.c_str(), links, H5P_DEFAULT),
               write_failure(path_, name));
}

void Hdf5File::remove(const std::string& object) {
  if (has(object)) {
    require_hdf5(H5Ldelete(id_, object.c_str(), H5P_DEFAULT), write_failure(path_, object));
  }
}

void Hdf5File::write(const std::string& dataset, const std::vector<double>& values, Shape shape) {
  const Hdf5Handle space = simple_space(shape.empty() ? Shape{values.size()} : shape);
  const Hdf5Handle links = group_making_links();
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(
      H5Dcreate2(id_, dataset.c_str(), H5T_IEEE_F64LE, space, links, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, failure);
  require_hdf5(H5Dwrite(owner, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               failure);
}

void Hdf5File::write(const std::string& dataset, const std::vector<int>& values) {
  const Hdf5Handle space = simple_space({values.size()});
  const Hdf5Handle links = group_making_links();
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(
      H5Dcreate2(id_, dataset.c_str(), H5T_STD_I32LE, space, links, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, failure);
  require_hdf5(H5Dwrite(owner, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               failure);
}

void Hdf5File::write_with_unit(const std::string& dataset, const std::vector<double>& values,
                               const std::string& unit, const Shape& shape) {
  write(dataset, values, shape);
  set_attribute(dataset, "unit", unit);
}

std::vector<double> Hdf5File::read(const std::string& dataset) const {
  const Hdf5Handle owner = open_plain_dataset(id_, path_, dataset);
  std::size_t count = 1;
  for (std::size_t size : shape(dataset)) {
    count *= size;
  }
  std::vector<double> values(count);
  require_hdf5(H5Dread(owner, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               read_failure(path_, dataset));
  return values;
}

} // namespace ionskin::results
