// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/data/skin_data.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/live/data/skin_archive.hpp"
#include "ionskin/live/data/slope_table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <functional>

namespace ionskin::live {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

constexpr std::string_view magic = "ionskin live skin, format 7\n";
/// Upper bound on the trained tilt in a file [rad]; training accepts up to 5 degrees.
constexpr double most_tilt = 0.1;
constexpr std::size_t most_waves = 1000, most_columns = 5000;
constexpr std::size_t largest_file = 256u << 20u;

template <class Archive, class Map>
void visit_nodes(Archive& archive, const std::string& name, Map& map) {
  archive.entry(name + ".lines_x", map.lines_x);
  archive.entry(name + ".lines_y", map.lines_y);
  archive.entry(name + ".amplitude", map.amplitude);
}

template <class Archive, class Model>
void visit_model(Archive& archive, const std::string& name, Model& model) {
  archive.entry(name + ".inputs", model.inputs);
  archive.entry(name + ".direct", model.direct);
  archive.entry(name + ".residue", model.residue);
}

/// Visits all entries of a file in their order. Reading and writing share this function, so that
/// the two layouts cannot differ.
/// @param archive `Writer` or `Reader`
template <class Archive, class Data> void visit(Archive& archive, Data& data) {
  archive.entry("version", data.version);
  archive.entry("case", data.case_text);
  archive.entry("command", data.command);
  archive.entry("seed", data.seed);
  archive.entry("trajectories", data.trajectories);
  archive.entry("friction_law", data.friction_law);
  archive.entry("friction", data.friction);
  archive.entry("lowest_friction", data.lowest_friction);
  archive.entry("highest_friction", data.highest_friction);
  archive.entry("friction_parameters", data.friction_parameters);
  archive.entry("friction_values", data.friction_values);
  archive.entry("cell_lines_x", data.cell_lines_x);
  archive.entry("cell_lines_y", data.cell_lines_y);
  archive.entry("area", data.area);
  archive.entry("gap", data.gap);
  visit_nodes(archive, "compliance", data.compliance);
  archive.symmetric("compliance.values", data.compliance.values, 3 * data.area.size());
  archive.entry("meshed_share", data.meshed_share);
  archive.entry("stiffness", data.stiffness);
  archive.entry("direction", data.direction);
  archive.entry("length", data.length);
  archive.entry("width", data.width);
  archive.entry("thickness", data.thickness);
  archive.list("channels", data.channels);
  for (auto& channel : data.channels) {
    archive.entry("channel.rows_per_point", channel.rows_per_point);
    visit_nodes(archive, "channel.strain", channel.strain);
    archive.entry("channel.strain.values", channel.strain.values);
    visit_nodes(archive, "channel.fit", channel.fit);
    archive.entry("channel.fit.values", channel.fit.values);
    archive.entry("channel.field", channel.field);
    archive.entry("channel.x_edges", channel.x_edges);
    archive.entry("channel.y_edges", channel.y_edges);
    archive.entry("channel.fixed_field", channel.fixed_field);
    archive.entry("channel.fixed_x_edges", channel.fixed_x_edges);
    archive.entry("channel.fixed_y_edges", channel.fixed_y_edges);
    archive.entry("channel.mean", channel.mean);
    archive.entry("channel.moment", channel.moment);
  }
  archive.entry("rates", data.rates);
  visit_model(archive, "whole", data.whole);
  visit_model(archive, "part", data.part);
  archive.entry("spread.columns_x", data.spread.columns_x);
  archive.entry("spread.columns_y", data.spread.columns_y);
  archive.entry("spread.wave_x", data.spread.wave_x);
  archive.entry("spread.wave_y", data.spread.wave_y);
  archive.entry("spread.rates", data.spread.rates);
  archive.entry("spread.weights", data.spread.weights);
  archive.entry("taxels", data.taxels);
  archive.entry("taxel_corners", data.taxel_corners);
  archive.entry("lowest_place", data.lowest_place);
  archive.entry("highest_place", data.highest_place);
  archive.entry("heaviest_force", data.heaviest_force);
  archive.entry("deepest_indentation", data.deepest_indentation);
  archive.entry("fastest", data.fastest);
  archive.entry("steepest", data.steepest);
  archive.entry("fastest_turn", data.fastest_turn);
  archive.entry("turns_into_itself", data.turns_into_itself);
  if (turns_underside(data)) {
    archive.entry("turned_gap", data.turned_gap);
  }
  archive.entry("slopes", data.slopes);
  archive.entry("lowest", data.lowest);
  archive.list("errors", data.errors);
  for (auto& error : data.errors) {
    archive.entry("error.name", error.name);
    archive.entry("error.event", error.event);
    archive.entry("error.rms", error.rms);
    archive.entry("error.worst", error.worst);
    archive.entry("error.largest", error.largest);
  }
}

bool ascend(const std::vector<double>& lines) {
  return std::ranges::adjacent_find(lines, std::greater_equal{}) == lines.end();
}

/// Throws UserError unless the sizes and nodes of a map are consistent.
/// @param size expected length of the vector
void check_map(const Reader& reader, const std::string& name, const PlaceMap& map,
               std::size_t size) {
  const std::size_t nodes = map.lines_x.size() * map.lines_y.size();
  reader.require(nodes > 0 && map.lines_x.size() <= most_lines &&
                     map.lines_y.size() <= most_lines && ascend(map.lines_x) && ascend(map.lines_y),
                 name);
  reader.require(map.amplitude.size() % nodes == 0 && map.modes() <= nodes &&
                     map.values.size() == (1 + map.modes()) * size,
                 name);
}

/// Throws UserError unless the arrays of a file fit each other and its numbers are plausible.
void check(const Reader& reader, const SkinData& data) {
  const std::size_t cells = data.area.size();
  reader.require(cells > 0 && cells < 10000 && data.gap.size() == cells, "gap");
  reader.require(data.cell_lines_x.size() >= 2 && data.cell_lines_y.size() >= 2 &&
                     (data.cell_lines_x.size() - 1) * (data.cell_lines_y.size() - 1) == cells,
                 "cell_lines_x");
  reader.require(ascend(data.cell_lines_x), "cell_lines_x");
  reader.require(ascend(data.cell_lines_y), "cell_lines_y");
  reader.require(std::ranges::all_of(data.area, [](double area) { return area > 0; }), "area");
  reader.require(data.lowest_friction >= 0 && data.lowest_friction <= data.friction &&
                     data.friction <= data.highest_friction,
                 "lowest_friction");
  reader.require(data.friction_parameters.size() == data.friction_values.size(), "friction_values");
  try {
    friction_of(data, data.friction);
  } catch (const std::exception&) { // this version lacks the law or a parameter
    reader.require(false, "friction_law");
  }
  check_map(reader, "compliance", data.compliance, 9 * cells * cells);
  reader.require(data.stiffness > 0, "stiffness");
  reader.require(data.meshed_share == 1 || data.meshed_share == 0.5, "meshed_share");
  reader.require(data.length > 0 && data.width > 0 && data.thickness > 0, "length");
  reader.require(data.channels.size() == 1 || data.channels.size() == 2, "channels");
  for (const ChannelMap& channel : data.channels) {
    reader.require(channel.rows_per_point >= 1 && channel.rows_per_point <= 6, "channel");
    const std::size_t row = channel.rows_per_point * 3 * cells;
    reader.require(channel.strain.values.size() % row == 0 && channel.x_edges.size() >= 2 &&
                       channel.y_edges.size() >= 2 && !channel.mean.empty() &&
                       channel.moment.size() == channel.mean.size(),
                   "channel");
    reader.require(ascend(channel.x_edges) && ascend(channel.y_edges) &&
                       ascend(channel.fixed_x_edges) && ascend(channel.fixed_y_edges),
                   "channel.x_edges");
    const std::size_t nodes = channel.strain.lines_x.size() * channel.strain.lines_y.size();
    reader.require(nodes > 0 && channel.strain.size() % row == 0, "channel.strain");
    const std::size_t points = channel.strain.size() / row;
    check_map(reader, "channel.strain", channel.strain, points * row);
    const std::size_t fits = channel.fit.lines_x.size() * channel.fit.lines_y.size();
    reader.require(points > 0 && fits > 0 && channel.fit.size() % points == 0, "channel.fit");
    check_map(reader, "channel.fit", channel.fit, channel.fit.size());
    reader.require(channel.fixed_x_edges.size() >= 2 && channel.fixed_y_edges.size() >= 2,
                   "channel.fixed_x_edges");
    const std::size_t values = channel.mean.size() * (channel.x_edges.size() - 1) *
                               (channel.y_edges.size() - 1),
                      fixed_values = channel.mean.size() * (channel.fixed_x_edges.size() - 1) *
                                     (channel.fixed_y_edges.size() - 1);
    reader.require(channel.fixed_field.size() % fixed_values == 0, "channel.fixed_field");
    reader.require(channel.field.size() % values == 0 &&
                       channel.field.size() / values + channel.fixed_field.size() / fixed_values ==
                           channel.fit.size() / points,
                   "channel.field");
  }
  const std::size_t levels = data.channels.back().mean.size();
  for (const ChargeModel* model : {&data.whole, &data.part}) {
    reader.require((model->inputs == levels || model->inputs == 2 * levels) &&
                       model->direct.size() == 2 * model->inputs &&
                       model->residue.size() == 2 * data.rates.size() * model->inputs,
                   "whole");
  }
  const SpreadMap& spread = data.spread;
  reader.require(spread.rates.size() <= most_waves && spread.wave_x.size() == spread.rates.size() &&
                     spread.wave_y.size() == spread.rates.size() &&
                     spread.weights.size() == (spread.rates.empty() ? 0 : levels),
                 "spread.rates");
  reader.require(spread.rates.empty() ||
                     (spread.columns_x >= 1 && spread.columns_x <= most_columns &&
                      spread.columns_y >= 1 && spread.columns_y <= most_columns),
                 "spread.columns_x");
  reader.require(std::ranges::all_of(spread.rates, [](double rate) { return rate >= 0; }),
                 "spread.rates");
  reader.require(data.taxel_corners.size() == 4 * data.taxels.size() && data.taxels.size() <= 1000,
                 "taxel_corners");
  reader.require(data.steepest >= 0 && data.steepest < most_tilt && data.fastest_turn >= 0 &&
                     data.turns_into_itself <= 1,
                 "steepest");
  reader.require(turns_underside(data)
                     ? !data.turned_gap.empty() && data.turned_gap.size() % data.area.size() == 0
                     : data.turned_gap.empty(),
                 "turned_gap");
  reader.require(data.steepest == 0
                     ? data.slopes.empty()
                     : is_table_of_slopes(data.slopes) &&
                           data.slopes.back() >= (1 - 1e-9) * std::tan(data.steepest) &&
                           data.slopes.front() <= -(1 - 1e-9) * std::tan(data.steepest),
                 "slopes");
  reader.require(data.lowest.size() == data.slopes.size() * data.slopes.size(), "lowest");
  reader.require(std::ranges::is_partitioned(
                     data.errors, [](const SignalError& error) { return error.event.empty(); }),
                 "error.event");
  reader.require(reader.at_end(), "error");
}

} // namespace

laws::Friction friction_of(const SkinData& data, double coefficient) {
  laws::LawValues values;
  for (std::size_t i = 0; i < data.friction_values.size(); ++i) {
    values[data.friction_parameters[i]] = data.friction_values[i];
  }
  return laws::friction(data.friction_law, coefficient, values);
}

std::string skin_bytes(const SkinData& data) {
  Writer writer(magic);
  visit(writer, data);
  return sealed(std::move(writer.bytes));
}

void write_skin(const std::filesystem::path& path, const SkinData& data) {
  const std::string bytes = skin_bytes(data);
  base::PendingFile file(path);
  file.write(std::as_bytes(std::span(bytes)));
  file.commit();
}

bool is_skin_file(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    return false; // reading from a pipe would consume its content
  }
  constexpr std::string_view start = magic.substr(0, magic.find(','));
  std::array<char, start.size()> bytes{};
  std::ifstream file(path, std::ios::binary);
  return file.read(bytes.data(), bytes.size()) &&
         std::string_view(bytes.data(), start.size()) == start;
}

SkinData skin_of_bytes(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with(magic.substr(0, magic.find(','))) ||
      bytes.size() < magic.size() + digest_digits) {
    refuse(path + ": is not a file of a live skin");
  }
  if (!bytes.starts_with(magic)) {
    refuse(path + ": another version of ionskin wrote it, in another format");
  }
  Reader reader(opened(bytes, path).substr(magic.size()), path);
  SkinData data;
  visit(reader, data);
  check(reader, data);
  return data;
}

SkinData read_skin(const std::filesystem::path& path) {
  std::error_code failure;
  const auto size = std::filesystem::file_size(path, failure);
  if (failure || !std::filesystem::is_regular_file(path, failure)) {
    throw UserError(path.string() + ": no such file of a live skin\n"
                                    "  = make one: ionskin live CASE.toml -o FILE");
  }
  std::string bytes(std::min<std::size_t>(size, largest_file), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    refuse(path.string() + ": cannot be read");
  }
  return skin_of_bytes(bytes, path.string());
}

bool validated_by_force(const SkinData& data) {
  // A height that is held has no error.
  return std::ranges::none_of(data.errors, [](const SignalError& error) {
    return error.name == "slider_z" && error.event.empty() && error.rms == 0;
  });
}

} // namespace ionskin::live
