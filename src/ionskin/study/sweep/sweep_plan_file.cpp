// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_plan_file.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/results/build_info.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace ionskin::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* digest_key = "digest"; ///< of everything else in the file
constexpr const char* again = "plan again: ionskin sweep CASE.toml --over KEY=VALUES --plan "
                              "--overwrite -o DIR, or with --resume in place of --overwrite to "
                              "keep what is finished";

/// A path may hold bytes that are no UTF-8.
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

SweepRequest request_of(const Json& json) {
  SweepRequest request;
  request.case_path = json.at("case_path").get<std::string>();
  request.case_text = json.at("case_text").get<std::string>();
  request.set_edits = json.at("set").get<std::vector<std::string>>();
  request.over = json.at("over").get<std::vector<std::string>>();
  request.samples = json.at("samples").get<std::size_t>();
  request.sampling = json.at("sampling") == "latin" ? Sampling::latin_hypercube : Sampling::sobol;
  request.seed = json.at("seed").get<std::uint64_t>();
  return request;
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

SweepPoint point_of(const Json& json) {
  SweepPoint point;
  point.name = json.at("name").get<std::string>();
  point.edits = json.at("edits").get<std::vector<std::string>>();
  for (const Json& value : json.at("values")) {
    point.values.push_back(
        {value.at("key").get<std::string>(), value.at("written").get<std::string>(),
         value.at("si").get<std::string>(), value.at("unit").get<std::string>()});
  }
  point.input_hash = json.at("input_hash").get<std::string>();
  point.mechanics_hash = json.at("mechanics_hash").get<std::string>();
  return point;
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

PlannedSweep sweep_of(const Json& json) {
  PlannedSweep sweep;
  sweep.plan.request = request_of(json.at("sweep"));
  sweep.studies = json.at("only") == "mechanics" ? Studies::mechanics : Studies::both;
  sweep.plan.points.resize(json.at("points").get<std::size_t>());
  for (const Json& one : json.at("batches")) {
    SweepBatch& batch = sweep.batches.emplace_back();
    batch.solutions = one.at("contact_solutions").get<std::size_t>();
    batch.threads = one.at("threads").get<int>();
    batch.memory = one.at("memory_bytes").get<double>();
    batch.seconds = one.at("seconds").get<double>();
    for (const Json& point : one.at("points")) {
      const auto i = point.at("number").get<std::size_t>() - 1;
      sweep.plan.points.at(i) = point_of(point);
      batch.points.push_back(i);
    }
  }
  return sweep;
}

PlannedSweep parse(const fs::path& path) {
  std::ifstream stream(path);
  Json json = Json::parse(stream, nullptr, false);
  const UserError damaged(
      fmt::format("{} is no plan of ionskin or is damaged\n  = {}", path.string(), again));
  try {
    const auto digest = json.at(digest_key).get<std::string>();
    json.erase(digest_key);
    if (digest != digest_of(json)) {
      throw damaged;
    }
    if (json.at("build") != build() || build().empty()) {
      throw UserError(fmt::format(
          "{} was made by another build of ionskin, whose results may differ\n  = use that build "
          "on all machines, or {}",
          path.string(), again));
    }
    return sweep_of(json);
  } catch (const nlohmann::json::exception&) {
    throw damaged;
  } catch (const std::out_of_range&) {
    throw damaged;
  }
}

void read_case_of(const SweepRequest& request, SweepPoint& point) {
  point.input = read_point_case(request, point.edits).input;
  if (input_hash(point.input) != point.input_hash) {
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
  return text_of(json);
}

PlannedSweep read_planned_sweep(const fs::path& folder, std::optional<std::size_t> batch) {
  const fs::path path = folder / results::file_names::sweep_plan;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
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
