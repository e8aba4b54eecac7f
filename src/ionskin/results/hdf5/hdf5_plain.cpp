// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_plain.hpp"

#include "ionskin/results/hdf5/hdf5_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ionskin::results {
namespace {

constexpr std::size_t most_dimensions = 8;
/// Largest depth of nested groups. A limit is needed because a group can contain itself.
constexpr int deepest_group = 16;
/// Largest size of one number and of one text [bytes]. Processors know numbers of up to 16 bytes;
/// texts hold whole case files.
constexpr std::size_t longest_number = 16, longest_text = 1u << 24;
constexpr double most_piece_bytes = 256e6;
constexpr hsize_t most_pieces = 1'000'000;
constexpr std::size_t least_cache = 1u << 20, most_cache = 1u << 29;
/// Number of slots of the hash table of the chunk cache; a prime.
constexpr std::size_t cache_slots = 10007;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& object,
                         const std::string& problem, const std::string& remedy) {
  throw UserError(fmt::format("{}: {} {}\n  = {}", path.string(), object, problem, remedy));
}

const char* kind_of(H5L_type_t link) {
  if (link == H5L_TYPE_EXTERNAL) {
    return "an external link";
  }
  return link == H5L_TYPE_SOFT ? "a soft link" : "a link that HDF5 does not define";
}

/// True if the link named `object` exists; throws UserError when it is not a hard link.
bool is_hard_link(hid_t file, const std::filesystem::path& path, const std::string& object) {
  if (H5Lexists(file, object.c_str(), H5P_DEFAULT) <= 0) {
    return false;
  }
  H5L_info_t info;
  if (H5Lget_info(file, object.c_str(), &info, H5P_DEFAULT) < 0) {
    return false;
  }
  if (info.type != H5L_TYPE_HARD) {
    refuse(path, object, fmt::format("is {}, which is not followed", kind_of(info.type)),
           "copy what it leads to into the file itself");
  }
  return true;
}

void require_plain(hid_t file, const std::filesystem::path& path, const std::string& object) {
  if (!has_plain(file, path, object)) {
    throw UserError(missing_object(path, object));
  }
}

void require_plain_type(hid_t dataset, const std::filesystem::path& path,
                        const std::string& object) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, read_failure(path, object));
  const H5T_class_t kind = H5Tget_class(type);
  const bool number = kind == H5T_FLOAT || kind == H5T_INTEGER;
  if (!number && kind != H5T_STRING) {
    refuse(path, object, "holds neither numbers nor texts", "write floating-point numbers");
  }
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || size > (number ? longest_number : longest_text)) {
    refuse(path, object, fmt::format("has entries of {} bytes", size),
           "write floating-point numbers of 8 bytes");
  }
}

std::vector<hsize_t> plain_extents(hid_t dataset, const std::filesystem::path& path,
                                   const std::string& object) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, read_failure(path, object));
  if (H5Sget_simple_extent_type(space) == H5S_NULL) {
    refuse(path, object, "is empty", "write its values");
  }
  const int dimensions = H5Sget_simple_extent_ndims(space);
  if (dimensions < 0 || static_cast<std::size_t>(dimensions) > most_dimensions) {
    refuse(path, object, fmt::format("has {} dimensions", dimensions),
           fmt::format("write it with at most {}", most_dimensions));
  }
  std::vector<hsize_t> extents(static_cast<std::size_t>(dimensions));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

void require_known_filters(hid_t properties, const std::filesystem::path& path,
                           const std::string& object) {
  constexpr std::array known{H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE, H5Z_FILTER_FLETCHER32};
  const int count = H5Pget_nfilters(properties);
  for (int i = 0; i < count; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(i), &flags,
                                               &values, nullptr, 0, nullptr, nullptr);
    if (std::find(known.begin(), known.end(), filter) == known.end()) {
      refuse(path, object, fmt::format("is stored through the HDF5 filter {}", filter),
             "write it with gzip, shuffle or fletcher32 only, or without compression");
    }
  }
}

/// Shape of the chunks of a chunked dataset.
std::vector<hsize_t> piece_extents(hid_t properties, std::size_t dimensions) {
  std::vector<hsize_t> piece(std::max<std::size_t>(dimensions, 1));
  H5Pget_chunk(properties, static_cast<int>(piece.size()), piece.data());
  piece.resize(dimensions);
  return piece;
}

double piece_bytes(hid_t dataset, const std::vector<hsize_t>& piece) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "HDF5 lacks the type of a dataset");
  double bytes = static_cast<double>(H5Tget_size(type));
  for (const hsize_t extent : piece) {
    bytes *= static_cast<double>(extent);
  }
  return bytes;
}

void require_written_pieces(hid_t dataset, hid_t properties, const std::vector<hsize_t>& extents,
                            const std::filesystem::path& path, const std::string& object) {
  const std::vector<hsize_t> piece = piece_extents(properties, extents.size());
  const double bytes = piece_bytes(dataset, piece);
  if (!(bytes > 0) || bytes > most_piece_bytes) {
    refuse(path, object, fmt::format("is stored in chunks of {:.3g} bytes", bytes),
           fmt::format("write it in chunks of at most {:.3g} bytes, such as one per sample",
                       most_piece_bytes));
  }
  double expected = 1;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    expected *= std::ceil(static_cast<double>(extents[i]) / static_cast<double>(piece[i]));
  }
  hsize_t written = 0;
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, read_failure(path, object));
  require_hdf5(H5Dget_num_chunks(dataset, space, &written), read_failure(path, object));
  if (static_cast<double>(written) < expected) {
    refuse(path, object,
           fmt::format("was never written completely: {} of its {:.15g} chunks are there", written,
                       expected),
           "write all of its values; 0 where nothing happens");
  }
  if (written > most_pieces) {
    refuse(path, object, fmt::format("is stored in {} chunks", written),
           "write it in larger chunks, such as one per sample");
  }
}

/// Throws UserError unless a dataset is plain, as hdf5_plain.hpp defines; checked before any of its
/// values is read.
void require_plain_storage(hid_t dataset, const std::filesystem::path& path,
                           const std::string& object) {
  require_plain_type(dataset, path, object);
  const std::vector<hsize_t> extents = plain_extents(dataset, path, object);
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, read_failure(path, object));
  const H5D_layout_t layout = H5Pget_layout(properties);
  if (layout == H5D_VIRTUAL) {
    refuse(path, object, "is a virtual dataset, whose values are in other files",
           "copy its values into the file itself");
  }
  if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) {
    throw UserError(read_failure(path, object));
  }
  if (H5Pget_external_count(properties) != 0) {
    refuse(path, object, "keeps its values in another file, which is not opened",
           "write its values into the file itself");
  }
  require_known_filters(properties, path, object);
  if (std::find(extents.begin(), extents.end(), hsize_t{0}) != extents.end()) {
    return;
  }
  if (layout == H5D_CHUNKED) {
    require_written_pieces(dataset, properties, extents, path, object);
  } else if (H5Dget_storage_size(dataset) == 0) {
    refuse(path, object, "was never written", "write all of its values; 0 where nothing happens");
  }
}

std::size_t cache_for_frame(hid_t dataset, const std::filesystem::path& path,
                            const std::string& object) {
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, read_failure(path, object));
  if (H5Pget_layout(properties) != H5D_CHUNKED) {
    return least_cache;
  }
  const std::vector<hsize_t> extents = plain_extents(dataset, path, object);
  const std::vector<hsize_t> piece = piece_extents(properties, extents.size());
  double bytes = piece_bytes(dataset, piece);
  for (std::size_t i = 1; i < extents.size(); ++i) {
    bytes *= std::ceil(static_cast<double>(extents[i]) / static_cast<double>(piece[i]));
  }
  return bytes > most_cache ? least_cache : std::max(least_cache, static_cast<std::size_t>(bytes));
}

std::vector<std::string> member_names(hid_t group, const std::filesystem::path& path,
                                      const std::string& name) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* member, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(member);
    return 0;
  };
  require_hdf5(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names),
               read_failure(path, name));
  return names;
}

void require_plain_below(hid_t file, const std::filesystem::path& path, const std::string& group,
                         int depth) {
  if (depth == 0) {
    refuse(path, group, "lies in too many groups", "write the file again");
  }
  const Hdf5Handle owner = open_plain_group(file, path, group);
  for (const std::string& name : member_names(owner, path, group)) {
    const std::string object = (group == "/" ? "" : group) + "/" + name;
    require_plain(file, path, object);
    H5O_info_t info;
    require_hdf5(H5Oget_info_by_name2(file, object.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT),
                 read_failure(path, object));
    if (info.type == H5O_TYPE_DATASET) {
      open_plain_dataset(file, path, object);
    } else {
      require_plain_below(file, path, object, depth - 1);
    }
  }
}

} // namespace

std::vector<std::string> plain_members(hid_t file, const std::filesystem::path& path,
                                       const std::string& group) {
  return member_names(open_plain_group(file, path, group), path, group);
}

void require_plain_content(hid_t file, const std::filesystem::path& path) {
  require_plain_below(file, path, "/", deepest_group);
}

bool has_plain(hid_t file, const std::filesystem::path& path, const std::string& object) {
  if (object == "/") {
    return true;
  }
  // H5Lexists requires that every group on the path exists.
  for (std::size_t slash = object.find('/', 1); slash != std::string::npos;
       slash = object.find('/', slash + 1)) {
    if (!is_hard_link(file, path, object.substr(0, slash))) {
      return false;
    }
  }
  return is_hard_link(file, path, object) &&
         H5Oexists_by_name(file, object.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle open_plain_dataset(hid_t file, const std::filesystem::path& path,
                              const std::string& object) {
  require_plain(file, path, object);
  Hdf5Handle dataset(H5Dopen2(file, object.c_str(), H5P_DEFAULT), H5Dclose,
                     missing_object(path, object));
  require_plain_storage(dataset, path, object);
  return dataset;
}

Hdf5Handle open_plain_group(hid_t file, const std::filesystem::path& path,
                            const std::string& object) {
  require_plain(file, path, object);
  return {H5Gopen2(file, object.c_str(), H5P_DEFAULT), H5Gclose, missing_object(path, object)};
}

Hdf5Handle open_plain_frames(hid_t file, const std::filesystem::path& path,
                             const std::string& object) {
  const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "HDF5 lacks access properties");
  {
    const Hdf5Handle dataset = open_plain_dataset(file, path, object);
    H5Pset_chunk_cache(access, cache_slots, cache_for_frame(dataset, path, object),
                       H5D_CHUNK_CACHE_W0_DEFAULT);
  }
  return {H5Dopen2(file, object.c_str(), access), H5Dclose, missing_object(path, object)};
}

} // namespace ionskin::results
