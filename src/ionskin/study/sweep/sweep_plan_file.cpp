// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_plan_file.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/results/build_info.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/units/dimension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

namespace fs = std::filesystem;
using base::Json;

constexpr std::size_t largest_file = 128U << 20;
constexpr std::uint64_t most_threads = 1U << 16;
constexpr double most_cost = 1e18; ///< largest estimate that a plan may hold [bytes] or [s]

constexpr const char* digest_key = "digest"; ///< digest of everything else in the file
constexpr const char* again = "plan again: ionskin sweep CASE.toml --over KEY=VALUES --plan "
                              "--overwrite -o DIR, or with --resume in place of --overwrite to "
                              "keep what is finished";

/// JSON text; bytes of paths that are not UTF-8 are replaced.
std::string text_of(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string digest_of(const Json& json) {
  return base::DigestBuilder().add(std::string_view(text_of(json))).finish().hex();
}

std::string build() {
  return base::own_build() ? base::own_build()->hex() : "";
}

Json request_json(const SweepRequest& request) {
  return {{"case_path", fs::absolute(request.case_path).lexically_normal().string()},
          {"case_text", request.case_text.value_or("")},
          {"set", request.set_edits},
          {"over", request.over},
          {"samples", request.samples},
          {"sampling", request.sampling == Sampling::sobol ? "sobol" : "latin"},
          {"seed", request.seed}};
}

Json point_json(const SweepPoint& point, std::size_t number) {
  Json values = Json::array();
  for (const SweptValue& value : point.values) {
    values.push_back(
        {{"key", value.key}, {"written", value.written}, {"si", value.si}, {"unit", value.unit}});
  }
  return {{"number", number},
          {"name", point.name},
          {"edits", point.edits},
          {"values", std::move(values)},
          {"input_hash", point.input_hash},
          {"mechanics_hash", point.mechanics_hash}};
}

Json batch_json(const SweepPlan& plan, const SweepBatch& batch, std::size_t number) {
  Json points = Json::array();
  for (const std::size_t i : batch.points) {
    points.push_back(point_json(plan.points[i], i + 1));
  }
  return {{"number", number},
          {"points", std::move(points)},
          {"contact_solutions", batch.solutions},
          {"threads", batch.threads},
          {"memory_bytes", std::ceil(batch.memory)},
          {"seconds", batch.seconds}};
}

/// Exception for a damaged plan; the user is not told the details.
class Damaged {};

void require(bool holds) {
  if (!holds) {
    throw Damaged();
  }
}

std::uint64_t count_of(const Json& json, std::uint64_t most) {
  require(json.is_number_unsigned() && json.get<std::uint64_t>() <= most);
  return json.get<std::uint64_t>();
}

double cost_of(const Json& json) {
  const auto value = json.get<double>();
  require(value >= 0 && value <= most_cost);
  return value;
}

std::string hash_of(const Json& json) {
  auto text = json.get<std::string>();
  require(text.size() <= 32 && text.find_first_not_of("0123456789abcdef") == std::string::npos);
  return text;
}

SweepRequest request_of(const Json& json) {
  SweepRequest request;
  request.case_path = json.at("case_path").get<std::string>();
  request.case_text = json.at("case_text").get<std::string>();
  request.set_edits = json.at("set").get<std::vector<std::string>>();
  request.over = json.at("over").get<std::vector<std::string>>();
  request.samples = count_of(json.at("samples"), std::numeric_limits<std::size_t>::max());
  request.sampling = json.at("sampling") == "latin" ? Sampling::latin_hypercube : Sampling::sobol;
  request.seed = count_of(json.at("seed"), std::numeric_limits<std::uint64_t>::max());
  return request;
}

bool is_si_unit(const std::string& unit) {
  return std::ranges::any_of(units::all_dimensions(), [&](units::Dimension dimension) {
    return units::dimension_info(dimension).si_unit == unit;
  });
}

bool is_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, status] = std::from_chars(text.data(), end, value);
  return status == std::errc() && rest == end && std::isfinite(value);
}

/// Reads what only the point's case can tell: values in SI units and hashes.
void take_point(const Json& json, SweepPoint& point) {
  const Json& values = json.at("values");
  require(values.is_array() && values.size() == point.values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    SweptValue& value = point.values[k];
    value.si = values[k].at("si").get<std::string>();
    value.unit = values[k].at("unit").get<std::string>();
    require(value.unit.empty() || (is_si_unit(value.unit) && is_number(value.si)));
  }
  point.input_hash = hash_of(json.at("input_hash"));
  point.mechanics_hash = hash_of(json.at("mechanics_hash"));
}

bool have_the_same_units(const std::vector<SweepPoint>& points) {
  const auto equal = [](const SweptValue& one, const SweptValue& other) {
    return one.unit == other.unit;
  };
  return std::ranges::all_of(points, [&](const SweepPoint& point) {
    return std::ranges::equal(point.values, points.front().values, equal);
  });
}

/// Plan from its JSON. Names and edits of the points are made from the request again, and every
/// point has to be in exactly one batch.
PlannedSweep sweep_of(const Json& json) {
  PlannedSweep sweep;
  sweep.plan.request = request_of(json.at("sweep"));
  sweep.studies = json.at("only") == "mechanics" ? Studies::mechanics : Studies::both;
  std::vector<SweepPoint>& points = sweep.plan.points;
  try {
    points = designed_points(sweep.plan.request);
  } catch (const UserError&) { // its remedy is for the user who plans a sweep
    throw Damaged();
  }
  std::vector<bool> taken(points.size());
  require(json.at("batches").is_array() && json.at("batches").size() <= points.size());
  for (const Json& one : json.at("batches")) {
    SweepBatch& batch = sweep.batches.emplace_back();
    batch.solutions = count_of(one.at("contact_solutions"), points.size());
    batch.threads = static_cast<int>(count_of(one.at("threads"), most_threads));
    batch.memory = cost_of(one.at("memory_bytes"));
    batch.seconds = cost_of(one.at("seconds"));
    require(batch.threads > 0 && one.at("points").is_array() && !one.at("points").empty());
    for (const Json& point : one.at("points")) {
      const std::size_t number = count_of(point.at("number"), points.size());
      require(number > 0 && !taken[number - 1]);
      taken[number - 1] = true;
      take_point(point, points[number - 1]);
      batch.points.push_back(number - 1);
    }
  }
  require(std::ranges::find(taken, false) == taken.end() && have_the_same_units(points));
  return sweep;
}

/// Reads a plan. It is intact if what was read makes the same text again, digest included.
PlannedSweep parse(const fs::path& path) {
  const auto json = base::read_json(path, "plan", largest_file);
  try {
    require(json.has_value());
    if (json->at("build") != build() || build().empty()) {
      throw UserError(fmt::format(
          "{} was made by another build of ionskin, whose results may differ\n  = use that build "
          "on all machines, or {}",
          path.string(), again));
    }
    PlannedSweep sweep = sweep_of(*json);
    require(plan_text(sweep.plan, sweep.batches, sweep.studies) == text_of(*json));
    return sweep;
  } catch (const Damaged&) {
  } catch (const nlohmann::json::exception&) {
  }
  throw UserError(fmt::format("{} is not a sweep plan that ionskin wrote, or is damaged\n  = {}",
                              path.string(), again));
}

void read_case_of(const SweepRequest& request, SweepPoint& point) {
  point.input = read_point_case(request, point.edits).input;
  const bool contact = point.input.strain.kind == StrainSourceKind::contact;
  if (input_hash(point.input) != point.input_hash ||
      (contact ? mechanics_hash(point.input) : "") != point.mechanics_hash) {
    throw UserError(fmt::format("the case of point {} is not what it was when the sweep was "
                                "planned: a file that it names has changed\n  = {}",
                                point.name, again));
  }
}

} // namespace

std::string plan_text(const SweepPlan& plan, const std::vector<SweepBatch>& batches,
                      Studies studies) {
  Json json;
  json["program"] = {{"name", "ionskin"}, {"version", results::build_info::version}};
  json["build"] = build();
  json["sweep"] = request_json(plan.request);
  json["only"] = studies == Studies::mechanics ? "mechanics" : "";
  json["points"] = plan.points.size();
  json["batches"] = Json::array();
  for (std::size_t i = 0; i < batches.size(); ++i) {
    json["batches"].push_back(batch_json(plan, batches[i], i));
  }
  json[digest_key] = digest_of(json);
  std::string text = text_of(json);
  if (text.size() > largest_file) {
    throw UserError(fmt::format("the plan of {} points has {} bytes, more than the {} that one may "
                                "have\n  = take fewer points, or vary fewer keys",
                                plan.points.size(), text.size(), largest_file));
  }
  return text;
}

PlannedSweep read_planned_sweep(const fs::path& folder, std::optional<std::size_t> batch) {
  const fs::path path = folder / results::file_names::sweep_plan;
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) {
    throw UserError(fmt::format("{} holds no plan.json\n  = plan the sweep first: ionskin sweep "
                                "CASE.toml --over KEY=VALUES --plan -o DIR",
                                folder.string()));
  }
  PlannedSweep sweep = parse(path);
  SweepPlan& plan = sweep.plan;
  if (batch && *batch >= sweep.batches.size()) {
    throw UserError(fmt::format("there is no batch {} in {}\n  = its batches are 0 to {}", *batch,
                                path.string(), sweep.batches.size() - 1));
  }
  for (const std::size_t i : batch ? sweep.batches[*batch].points : std::vector<std::size_t>()) {
    read_case_of(plan.request, plan.points[i]);
  }
  if (!batch) {
    SweepPoint first = plan.points.front();
    read_case_of(plan.request, first);
    plan.base = base_case(plan.request, std::move(first.input));
  }
  return sweep;
}

} // namespace ionskin::study
