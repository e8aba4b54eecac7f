// SPDX-License-Identifier: Apache-2.0
// Texts and attributes of Hdf5File.
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include "ionskin/results/hdf5/hdf5_handle.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/hdf5/hdf5_plain.hpp"

#include <algorithm>

namespace ionskin::results {
namespace {

// HDF5 type of UTF-8 text: of a fixed length in bytes, padded with zeros, or of variable length for
// H5T_VARIABLE.
Hdf5Handle text_type(std::size_t length) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  if (length != H5T_VARIABLE) {
    H5Tset_strpad(type, H5T_STR_NULLPAD);
  }
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose, "HDF5 lacks its text type"};
}

Hdf5Handle scalar_space() {
  return {H5Screate(H5S_SCALAR), H5Sclose, "HDF5 lacks scalars"};
}

std::string up_to_padding(const char* text, std::size_t length) {
  return {text, std::find(text, text + length, '\0')};
}

/// Largest length of an attribute [bytes]: names, units, and reasons in a sentence.
constexpr std::size_t longest_attribute = 1u << 16;

// Reads one text of fixed or variable length. Nothing (`nullopt`) when it is not a text or cannot
// be read. `read` is H5Dread or H5Aread bound to its object.
template <class Read> std::optional<std::string> read_one_text(hid_t file_type, const Read& read) {
  if (H5Tget_class(file_type) != H5T_STRING) {
    return std::nullopt;
  }
  const Hdf5Handle memory(H5Tcopy(file_type), H5Tclose, "HDF5 cannot copy a type");
  if (H5Tis_variable_str(file_type) > 0) {
    char* text = nullptr;
    if (read(memory, static_cast<void*>(&text)) < 0 || text == nullptr) {
      return std::nullopt;
    }
    std::string result(text);
    H5free_memory(text);
    return result;
  }
  std::string padded(H5Tget_size(file_type), '\0');
  if (read(memory, static_cast<void*>(padded.data())) < 0) {
    return std::nullopt;
  }
  return up_to_padding(padded.data(), padded.size());
}

// Opens an object for its attributes, or creates it as a group if it does not exist.
Hdf5Handle open_or_make(hid_t file, const std::filesystem::path& path, const std::string& object,
                        bool exists) {
  const std::string failure = write_failure(path, object);
  if (exists) {
    return {H5Oopen(file, object.c_str(), H5P_DEFAULT), H5Oclose, failure};
  }
  const Hdf5Handle links = group_making_links();
  return {H5Gcreate2(file, object.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Oclose, failure};
}

void write_attribute(hid_t owner, const std::string& name, hid_t file_type, hid_t memory_type,
                     const void* value, const std::string& failure) {
  if (H5Aexists(owner, name.c_str()) > 0) {
    require_hdf5(H5Adelete(owner, name.c_str()), failure);
  }
  const Hdf5Handle space = scalar_space();
  const Hdf5Handle attribute(
      H5Acreate2(owner, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      failure);
  require_hdf5(H5Awrite(attribute, memory_type, value), failure);
}

bool is_scalar(hid_t attribute) {
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, "HDF5 cannot size an attribute");
  return H5Sget_simple_extent_npoints(space) == 1;
}

} // namespace

void Hdf5File::write_text(const std::string& dataset, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space = scalar_space();
  const Hdf5Handle links = group_making_links();
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(
      H5Dcreate2(id_, dataset.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
      failure);
  require_hdf5(H5Dwrite(owner, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), failure);
}

void Hdf5File::write_texts(const std::string& dataset, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) {
    longest = std::max(longest, text.size());
  }
  std::vector<char> padded(std::max<std::size_t>(1, texts.size() * longest), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::copy(texts[i].begin(), texts[i].end(), padded.begin() + static_cast<long>(i * longest));
  }
  const hsize_t count = texts.size();
  const Hdf5Handle type = text_type(longest);
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "HDF5 refuses a list");
  const Hdf5Handle links = group_making_links();
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(
      H5Dcreate2(id_, dataset.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
      failure);
  require_hdf5(H5Dwrite(owner, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), failure);
}

std::string Hdf5File::read_text(const std::string& dataset) const {
  const Hdf5Handle owner = open_plain_dataset(id_, path_, dataset);
  const Hdf5Handle type(H5Dget_type(owner), H5Tclose, read_failure(path_, dataset));
  const Hdf5Handle space(H5Dget_space(owner), H5Sclose, read_failure(path_, dataset));
  if (H5Sget_simple_extent_npoints(space) != 1) {
    throw UserError(read_failure(path_, dataset));
  }
  const std::optional<std::string> text = read_one_text(type, [&](hid_t memory, void* target) {
    return H5Dread(owner, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, target);
  });
  if (!text) {
    throw UserError(read_failure(path_, dataset));
  }
  return *text;
}

std::vector<std::string> Hdf5File::read_texts(const std::string& dataset) const {
  const Hdf5Handle owner = open_plain_dataset(id_, path_, dataset);
  const Hdf5Handle type(H5Dget_type(owner), H5Tclose, read_failure(path_, dataset));
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
    throw UserError(read_failure(path_, dataset));
  }
  const std::size_t length = H5Tget_size(type);
  const Shape extents = shape(dataset);
  if (extents.size() != 1) {
    throw UserError(read_failure(path_, dataset));
  }
  const std::size_t count = extents[0];
  std::vector<char> padded(std::max<std::size_t>(1, count * length));
  require_hdf5(H5Dread(owner, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()),
               read_failure(path_, dataset));
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    texts.push_back(up_to_padding(padded.data() + i * length, length));
  }
  return texts;
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             const std::string& text) {
  // With variable length, h5py returns the attribute as text rather than bytes.
  const Hdf5Handle type = text_type(H5T_VARIABLE);
  const char* characters = text.c_str();
  write_attribute(open_or_make(id_, path_, object, has(object)), name, type, type, &characters,
                  write_failure(path_, object + "@" + name));
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(open_or_make(id_, path_, object, has(object)), name, H5T_IEEE_F64LE,
                  H5T_NATIVE_DOUBLE, &value, write_failure(path_, object + "@" + name));
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, int value) {
  write_attribute(open_or_make(id_, path_, object, has(object)), name, H5T_STD_I32LE,
                  H5T_NATIVE_INT, &value, write_failure(path_, object + "@" + name));
}

std::optional<std::string> Hdf5File::text_attribute(const std::string& object,
                                                    const std::string& name) const {
  if (!has(object) || H5Aexists_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) {
    return std::nullopt;
  }
  const Hdf5Handle attribute(
      H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      read_failure(path_, object));
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, read_failure(path_, object));
  if (!is_scalar(attribute) || H5Tget_size(type) > longest_attribute) {
    return std::nullopt;
  }
  const auto text = read_one_text(
      type, [&](hid_t memory, void* target) { return H5Aread(attribute, memory, target); });
  return text && text->size() <= longest_attribute ? text : std::nullopt;
}

std::optional<double> Hdf5File::number_attribute(const std::string& object,
                                                 const std::string& name) const {
  if (!has(object) || H5Aexists_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) {
    return std::nullopt;
  }
  const Hdf5Handle attribute(
      H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      read_failure(path_, object));
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, read_failure(path_, object));
  const H5T_class_t kind = H5Tget_class(type);
  double value = 0;
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || !is_scalar(attribute) ||
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) {
    return std::nullopt;
  }
  return value;
}

} // namespace ionskin::results
