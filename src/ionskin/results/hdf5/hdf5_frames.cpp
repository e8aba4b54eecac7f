// SPDX-License-Identifier: Apache-2.0
// Frame-wise datasets of Hdf5File: one compressed chunk per frame.
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include "ionskin/results/hdf5/hdf5_handle.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/hdf5/hdf5_open_frames.hpp"
#include "ionskin/results/hdf5/hdf5_plain.hpp"

namespace ionskin::results {
namespace {

// The lowest level already compresses the runs of zero bytes that the shuffle filter brings
// together.
constexpr unsigned deflate_level = 1;

std::vector<hsize_t> frame_extents(const Hdf5File::Shape& shape) {
  std::vector<hsize_t> extents(shape.begin(), shape.end());
  extents.at(0) = 1;
  return extents;
}

std::vector<hsize_t> frame_origin(const Hdf5File::Shape& shape, std::size_t frame) {
  std::vector<hsize_t> origin(shape.size(), 0);
  origin.at(0) = frame;
  return origin;
}

std::size_t frame_values(const Hdf5File::Shape& shape) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < shape.size(); ++i) {
    count *= shape[i];
  }
  return count;
}

// HDF5 dataspaces of one frame of an open dataset: its selection in the file, and its shape in
// memory.
struct FrameSpaces {
  FrameSpaces(hid_t dataset, const Hdf5File::Shape& shape, std::size_t frame,
              const std::string& failure)
      : extents(frame_extents(shape)), file(H5Dget_space(dataset), H5Sclose, failure),
        memory(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
               H5Sclose, failure) {
    const std::vector<hsize_t> origin = frame_origin(shape, frame);
    require_hdf5(
        H5Sselect_hyperslab(file, H5S_SELECT_SET, origin.data(), nullptr, extents.data(), nullptr),
        failure);
  }
  std::vector<hsize_t> extents;
  Hdf5Handle file, memory;
};

} // namespace

void Hdf5File::create_frames(const std::string& dataset, const Shape& shape) {
  const std::string failure = write_failure(path_, dataset);
  const std::vector<hsize_t> size(shape.begin(), shape.end());
  const std::vector<hsize_t> chunk = frame_extents(shape);
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                         H5Sclose, failure);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, failure);
  H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties);
  H5Pset_deflate(properties, deflate_level);
  const Hdf5Handle links = group_making_links();
  const Hdf5Handle owner(
      H5Dcreate2(id_, dataset.c_str(), H5T_IEEE_F64LE, space, links, properties, H5P_DEFAULT),
      H5Dclose, failure);
}

void Hdf5File::write_frame(const std::string& dataset, std::size_t frame,
                           const std::vector<double>& values) {
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(H5Dopen2(id_, dataset.c_str(), H5P_DEFAULT), H5Dclose, failure);
  const Shape whole = shape(dataset);
  if (values.size() != frame_values(whole)) {
    throw InternalError(fmt::format("a frame of {} has {} values, not {}", dataset,
                                    frame_values(whole), values.size()));
  }
  const FrameSpaces spaces(owner, whole, frame, failure);
  require_hdf5(
      H5Dwrite(owner, H5T_NATIVE_DOUBLE, spaces.memory, spaces.file, H5P_DEFAULT, values.data()),
      failure);
}

void Hdf5File::repeat_frame(const std::string& dataset, std::size_t source, std::size_t frame) {
  const std::string failure = write_failure(path_, dataset);
  const Hdf5Handle owner(H5Dopen2(id_, dataset.c_str(), H5P_DEFAULT), H5Dclose, failure);
  const Shape whole = shape(dataset);
  const std::vector<hsize_t> from = frame_origin(whole, source);
  const std::vector<hsize_t> to = frame_origin(whole, frame);
  hsize_t bytes = 0;
  require_hdf5(H5Dget_chunk_storage_size(owner, from.data(), &bytes), failure);
  std::vector<unsigned char> compressed(bytes);
  std::uint32_t skipped_filters = 0;
  require_hdf5(H5Dread_chunk(owner, H5P_DEFAULT, from.data(), &skipped_filters, compressed.data()),
               failure);
  require_hdf5(
      H5Dwrite_chunk(owner, H5P_DEFAULT, skipped_filters, to.data(), bytes, compressed.data()),
      failure);
}

void Hdf5File::read_frame(const std::string& dataset, std::size_t frame,
                          std::vector<double>& values) const {
  const std::string failure = read_failure(path_, dataset);
  if (!frames_ || frames_->name != dataset) {
    frames_.reset();
    frames_ = std::make_unique<OpenFrames>(dataset, open_plain_frames(id_, path_, dataset));
  }
  const Shape whole = shape(dataset);
  if (whole.empty() || frame >= whole[0]) {
    throw UserError(failure);
  }
  values.resize(frame_values(whole));
  const FrameSpaces spaces(frames_->dataset, whole, frame, failure);
  require_hdf5(H5Dread(frames_->dataset, H5T_NATIVE_DOUBLE, spaces.memory, spaces.file, H5P_DEFAULT,
                       values.data()),
               failure);
}

} // namespace ionskin::results
