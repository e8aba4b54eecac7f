// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/fmu/archive.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/live/fmu/model_description.hpp"

#include <minizip/zip.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace ionskin::live::fmu {
namespace {

/// Zip archive that is being written. Throws base::UnwritableFile where writing fails.
class Archive {
public:
  /// Creates the archive.
  /// @param name path of the finished file, for messages
  Archive(const std::filesystem::path& path, std::filesystem::path name)
      : name_(std::move(name)), zip_(zipOpen64(path.c_str(), APPEND_STATUS_CREATE)) {
    require(zip_ != nullptr);
  }
  ~Archive() {
    if (zip_ != nullptr) {
      zipClose(zip_, nullptr);
    }
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// Adds a file with a fixed date, so that the same skin gives the same bytes.
  /// @param entry path within the archive
  void add(const std::string& entry, std::string_view bytes) {
    zip_fileinfo info{};
    constexpr unsigned long first_of_1980 = 0x210000; // 1 January, the format's earliest date
    info.dosDate = first_of_1980;
    constexpr unsigned long regular_file = 0100644ul << 16u; // permissions that unzip sets on Unix
    info.external_fa = regular_file;
    constexpr unsigned long made_on_unix = 3ul << 8u;
    require(zipOpenNewFileInZip4_64(zip_, entry.c_str(), &info, nullptr, 0, nullptr, 0, nullptr,
                                    Z_DEFLATED, Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                                    Z_DEFAULT_STRATEGY, nullptr, 0, made_on_unix, 0, 0) == ZIP_OK);
    require(zipWriteInFileInZip(zip_, bytes.data(), static_cast<unsigned>(bytes.size())) == ZIP_OK);
    require(zipCloseFileInZip(zip_) == ZIP_OK);
  }
  void close() {
    const zipFile zip = zip_;
    zip_ = nullptr;
    require(zipClose(zip, nullptr) == ZIP_OK);
  }

private:
  void require(bool written) const {
    if (!written) {
      throw base::UnwritableFile(name_, "the archive could not be completed");
    }
  }

  std::filesystem::path name_;
  zipFile zip_;
};

} // namespace

void write_fmu(const std::filesystem::path& path, const SkinData& data,
               const std::filesystem::path& library) {
  std::ifstream file(library, std::ios::binary);
  const std::string binary{std::istreambuf_iterator<char>(file), {}};
  if (binary.empty()) {
    throw UserError(library.string() + ": the library that goes into an FMU cannot be read\n"
                                       "  = build it (make build), or install all parts of "
                                       "ionskin");
  }
  base::PendingFile pending(path);
  Archive archive(pending.path(), path);
  archive.add("modelDescription.xml", model_description(data, path.stem().string()));
  archive.add("resources/skin.live", skin_bytes(data));
  archive.add(std::string("binaries/linux64/") + model_identifier + ".so", binary);
  archive.close();
  pending.commit();
}

} // namespace ionskin::live::fmu
