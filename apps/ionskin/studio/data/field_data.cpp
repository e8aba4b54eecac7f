// SPDX-License-Identifier: Apache-2.0
#include "studio/data/field_data.hpp"

#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "studio/data/packed.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numeric>

namespace ionskin::apps::studio {
namespace {

using results::Hdf5File;

/// The members of a group, the grid left out, in the order of their instants.
Json frames(const Hdf5File& file, const std::string& group, const char* instant) {
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

Json ions(const Hdf5File& file) {
  if (!file.has("/ions/grid/x")) {
    return nullptr;
  }
  return {{"x", file.read("/ions/grid/x")},
          {"y", file.read("/ions/grid/y")},
          {"z", file.read("/ions/grid/z")},
          {"frames", frames(file, "/ions", "time")}};
}

Json strain(const Hdf5File& file) {
  if (!file.has("/strain/gamma")) {
    return nullptr;
  }
  Json all = {{"x", file.read("/strain/grid/x")},
              {"y", file.read("/strain/grid/y")},
              {"z", file.read("/strain/grid/z")},
              {"time", file.read("/strain/time")},
              {"frame", file.text_attribute("/strain", "frame").value_or("skin")}};
  for (const char* name : {"slider_x", "slider_y"}) {
    const std::string path = std::string("/strain/") + name;
    all[name] = file.has(path) ? Json(file.read(path)) : Json();
  }
  return all;
}

Json contact(const Hdf5File& file) {
  if (!file.has("/contact/grid/x")) {
    return nullptr;
  }
  return {{"x", file.read("/contact/grid/x")},
          {"y", file.read("/contact/grid/y")},
          {"frames", frames(file, "/contact", "parameter")}};
}

/// A name inside the file, never a path.
void require_name(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos || name == "." || name == "..") {
    throw HttpError(404, "there is no such field");
  }
}

std::string message(const std::vector<double>& values, const Hdf5File::Shape& shape,
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

} // namespace

Json list_fields(const std::filesystem::path& results) {
  const Hdf5File file(results, Hdf5File::Access::read);
  return {{"ions", ions(file)}, {"strain", strain(file)}, {"contact", contact(file)}};
}

std::string packed_field(const std::filesystem::path& results, const std::string& group,
                         const std::string& frame, const std::string& name) {
  require_name(frame);
  require_name(name);
  const Hdf5File file(results, Hdf5File::Access::read);
  const bool is_strain = group == "strain";
  if (!is_strain && group != "ions" && group != "contact") {
    throw HttpError(404, "there is no such field");
  }
  const std::string path = is_strain ? "/strain/gamma" : "/" + group + "/" + frame + "/" + name;
  if (!file.has_numbers(path)) {
    throw HttpError(404, "there is no such field");
  }
  Hdf5File::Shape shape = file.shape(path);
  const std::string unit = file.text_attribute(path, "unit").value_or("1");
  if (group == "contact") {
    return message(file.read(path), shape, unit);
  }
  std::size_t number = 0;
  if (is_strain) {
    std::from_chars(frame.data(), frame.data() + frame.size(), number);
  }
  if (shape.size() != 4 || number >= shape[0]) {
    throw HttpError(404, "there is no such instant");
  }
  shape.erase(shape.begin());
  if (std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()) >
      limits::frame_values) {
    throw HttpError(413, "this field is too large to be shown; ParaView reads it");
  }
  std::vector<double> values;
  file.read_frame(path, number, values);
  return message(values, shape, unit);
}

} // namespace ionskin::apps::studio
