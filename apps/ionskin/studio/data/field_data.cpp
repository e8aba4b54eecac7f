// SPDX-License-Identifier: Apache-2.0
#include "studio/data/field_data.hpp"

#include "ionskin/base/error.hpp"
#include "studio/data/packed.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sys/stat.h>

namespace ionskin::apps::studio {
namespace {

using results::ForeignHdf5File;

/// Throws HttpError 413 when an array has too many values for a page, before it is read. Only
/// dimensions from `first` on count.
void require_shown(const ForeignHdf5File::Shape& shape, std::size_t first = 0) {
  double values = 1;
  for (std::size_t d = first; d < shape.size(); ++d) {
    values *= static_cast<double>(shape[d]);
  }
  if (values > limits::frame_values) {
    throw HttpError(413, "this field is too large to be shown; ParaView reads it");
  }
}

/// Reads the lines of a grid, or instants.
std::vector<double> line(const ForeignHdf5File& file, const std::string& path) {
  require_shown(file.shape(path));
  return file.read(path);
}

/// Lists the instants in a group of the file, in the order of time or path parameter; its grid is
/// left out.
Json frames(const ForeignHdf5File& file, const std::string& group, const char* instant) {
  Json list = Json::array();
  for (const std::string& name : file.members(group)) {
    if (name != "grid") {
      const std::string path = group + "/" + name;
      list.push_back({{"name", name},
                      {"time", file.number_attribute(path, instant).value_or(0)},
                      {"fields", file.members(path)}});
    }
  }
  std::stable_sort(list.begin(), list.end(), [](const Json& a, const Json& b) {
    return a["time"].get<double>() < b["time"].get<double>();
  });
  return list;
}

Json ions(const ForeignHdf5File& file) {
  if (!file.has("/ions/grid/x")) {
    return nullptr;
  }
  return {{"x", line(file, "/ions/grid/x")},
          {"y", line(file, "/ions/grid/y")},
          {"z", line(file, "/ions/grid/z")},
          {"frames", frames(file, "/ions", "time")}};
}

Json strain(const ForeignHdf5File& file) {
  if (!file.has("/strain/gamma")) {
    return nullptr;
  }
  Json all = {{"x", line(file, "/strain/grid/x")},
              {"y", line(file, "/strain/grid/y")},
              {"z", line(file, "/strain/grid/z")},
              {"time", line(file, "/strain/time")},
              {"frame", file.text_attribute("/strain", "frame").value_or("skin")}};
  for (const char* name : {"slider_x", "slider_y"}) {
    const std::string path = std::string("/strain/") + name;
    all[name] = file.has(path) ? Json(line(file, path)) : Json();
  }
  return all;
}

Json contact(const ForeignHdf5File& file) {
  if (!file.has("/contact/grid/x")) {
    return nullptr;
  }
  return {{"x", line(file, "/contact/grid/x")},
          {"y", line(file, "/contact/grid/y")},
          {"frames", frames(file, "/contact", "parameter")}};
}

/// Requires a plain name of a group or dataset, not a path. Throws HttpError 404.
void require_name(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos || name == "." || name == "..") {
    throw HttpError(404, "there is no such field");
  }
}

std::string message(const std::vector<double>& values, const ForeignHdf5File::Shape& shape,
                    const std::string& unit) {
  const std::vector<float> numbers(values.begin(), values.end());
  double least = INFINITY, greatest = -INFINITY;
  for (const double value : values) {
    if (std::isfinite(value)) {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  return packed(Json{{"shape", shape},
                     {"unit", unit},
                     {"least", least <= greatest ? Json(least) : Json()},
                     {"greatest", least <= greatest ? Json(greatest) : Json()}},
                numbers);
}

std::string one_frame(const ForeignHdf5File& file, const std::string& path, std::size_t number,
                      const std::string& unit) {
  ForeignHdf5File::Shape shape = file.shape(path);
  if (shape.size() != 4 || number >= shape[0]) {
    throw HttpError(404, "there is no such instant");
  }
  require_shown(shape, 1);
  shape.erase(shape.begin());
  std::vector<double> values;
  file.read_frame(path, number, values);
  return message(values, shape, unit);
}

} // namespace

namespace {

FieldData::Version version_of(const Opened& results) {
  struct stat status {};
  ::fstat(results.file, &status);
  return {static_cast<long long>(status.st_dev), static_cast<long long>(status.st_ino),
          status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

} // namespace

template <class Read> auto FieldData::with(const Opened& results, const Read& read) {
  const std::lock_guard lock(mutex_);
  const Version version = version_of(results);
  const std::string path = path_of(results.file).string();
  try {
    if (!file_ || version != version_) {
      file_.reset();
      auto file = std::make_unique<ForeignHdf5File>(path);
      file->require_plain();
      file_ = std::move(file);
      version_ = version;
    }
    return read(*file_);
  } catch (const UserError& error) {
    file_.reset(); // its reader may have ended
    std::string text = error.what();
    if (const std::size_t at = text.find("/proc/self/fd/"); at != std::string::npos) {
      const std::size_t end = text.find_first_not_of("0123456789", at + 14);
      text.replace(at, end - at, results.name);
    }
    throw UserError(text);
  }
}

Json FieldData::list(const Opened& results) {
  return with(results, [](const ForeignHdf5File& file) -> Json {
    return {{"ions", ions(file)}, {"strain", strain(file)}, {"contact", contact(file)}};
  });
}

std::string FieldData::packed(const Opened& results, const std::string& group,
                              const std::string& frame, const std::string& name) {
  require_name(frame);
  require_name(name);
  const bool is_strain = group == "strain";
  if (!is_strain && group != "ions" && group != "contact") {
    throw HttpError(404, "there is no such field");
  }
  const std::string path = is_strain ? "/strain/gamma" : "/" + group + "/" + frame + "/" + name;
  std::size_t number = 0; // in the dataset of the strain; any other has one frame
  if (is_strain) {
    std::from_chars(frame.data(), frame.data() + frame.size(), number);
  }
  return with(results, [&](const ForeignHdf5File& file) {
    if (!file.has_numbers(path)) {
      throw HttpError(404, "there is no such field");
    }
    const std::string unit = file.text_attribute(path, "unit").value_or("1");
    return group == "contact" ? message(line(file, path), file.shape(path), unit)
                              : one_frame(file, path, number, unit);
  });
}

} // namespace ionskin::apps::studio
