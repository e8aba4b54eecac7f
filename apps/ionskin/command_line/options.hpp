// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "command_line/completion.hpp"
#include "verbs/cache.hpp"
#include "verbs/check.hpp"
#include "verbs/cite.hpp"
#include "verbs/init.hpp"
#include "verbs/keys.hpp"

namespace ionskin::apps {

/// Form in which progress is shown. `automatic`: a bar on a terminal and lines elsewhere. `quiet`:
/// nothing, and no summary of the results either.
enum class LogFormat { automatic, bar, lines, json, none, quiet };

struct RunOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  int threads = 0; ///< 0: all processors
  bool overwrite = false;
  bool resume = false;
  bool no_report = false;
  bool figures = false; ///< of the report, as files too
  std::string only;     ///< "mechanics", "electrochemistry" or empty for both
  LogFormat log = LogFormat::automatic;
};

struct SweepOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> over; ///< "KEY=first:step:last", "KEY=value,value" or "KEY=a:b"
  std::vector<std::string> set_edits;
  std::size_t samples = 0; ///< 0: a grid
  std::string sampling = "sobol";
  std::uint64_t seed = 1;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  bool no_report = false;
  bool figures = false;             ///< of the report, as files too
  std::string only;                 ///< "mechanics" or empty for both studies
  bool explain = false;             ///< say what it costs, and stop
  bool plan = false;                ///< write plan.json, and stop
  std::optional<std::size_t> batch; ///< of a planned sweep, the one to do
  bool collect = false;             ///< only write the tables of a planned sweep
  std::string on;                   ///< file of a cluster's scheduler; empty for this machine
  LogFormat log = LogFormat::automatic;
};

struct ClusterOptions {
  std::string action; ///< "start", "worker" or "stop"
  std::string folder;
  std::string address = "127.0.0.1";
  bool tls = false;
  int workers = 1, threads = 0; ///< 0 threads: all processors
  double memory = 0;            ///< of a worker [bytes]; 0: what is free
  double death_timeout = 60;    ///< [s]
};

struct FitOptions {
  std::string case_path, data_path, output;
  std::vector<std::string> free; ///< keys, each a name or several with commas
  std::string column;            ///< of the data; empty when only one can be fitted
  std::vector<std::string> set_edits;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  LogFormat log = LogFormat::automatic;
};

/// Options of uncertainty, design and generate, which ionskin's Python package carries out.
struct TrialOptions {
  std::string case_path, output;
  std::string on; ///< file of a cluster's scheduler; empty for this machine
  std::vector<std::string> set_edits;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  bool quiet = false;
};

struct UncertaintyOptions : TrialOptions {
  std::vector<std::string> vary; ///< "KEY=DISTRIBUTION"
  std::size_t samples = 64;
  std::string design = "sobol";
  std::uint64_t seed = 1;
  std::vector<std::string> metrics; ///< empty for the usual ones
  double least_q2 = 0.95;           ///< of a surrogate that is used
};

struct DesignOptions : TrialOptions {
  std::vector<std::string> free, subject_to; ///< "KEY=lowest:highest unit", "METRIC < value"
  std::string maximise, minimise;            ///< a metric in one of them
  std::size_t budget = 60;                   ///< evaluations at most
  std::uint64_t seed = 1;
};

struct GenerateOptions : TrialOptions {
  std::vector<std::string> vary; ///< besides the finger and its motion, or in their place
  std::size_t touches = 0;
  std::uint64_t seed = 1;
};

/// A path of waypoints from recordings, which ionskin's Python package makes. Texts as written,
/// empty for what the recording tells.
struct MotionOptions {
  std::vector<std::string> recordings;
  std::string output;
  std::vector<std::string> columns; ///< "ROLE=NAME" or "ROLE=NAME [unit]"
  std::string origin, x_axis, y_axis, tool, force_in = "skin", level = "auto";
  std::string contact_force, gap, rate, filter;
  bool tare = false;
  bool overwrite = false;
  bool quiet = false;
};

struct ReportOptions {
  std::string folder;
  std::vector<std::string> figures; ///< only these, as files; empty for the page
  bool files = false;               ///< every figure as a file too
  bool claims = false;              ///< judge the paper's claims whatever the case
  LogFormat log = LogFormat::automatic;
};

struct CompareOptions {
  std::string first, second; ///< run folders
  double tolerance = 1e-9;   ///< relative differences up to here are not differences
};

struct StudioOptions {
  std::string folder = "."; ///< with cases and results
  int port = 0;             ///< 0: any that is free
  bool no_browser = false;
};

struct DoctorOptions {};
struct ManualOptions {};

struct VerifyOptions {
  std::string part; ///< "mechanics", "electrochemistry", "poroelasticity", "chain" or empty
  std::string csv;  ///< file for the table; empty for none
  int threads = 0;
};

struct ImpedanceOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  std::string from, to; ///< frequencies with unit
  int points = 10;      ///< per decade
  bool overwrite = false;
};

struct LiveOptions {
  std::string case_path; ///< or that of a live skin that is there
  std::string output;    ///< a file; empty where only an FMU is wanted
  std::string fmu;       ///< a file; empty for none
  std::vector<std::string> set_edits;
  std::size_t trajectories = 12;
  std::size_t validation = 90;
  std::uint64_t seed = 1;
  std::optional<std::array<double, 2>> friction;
  double tilt = 0;           ///< steepest [deg]
  double spin = 0;           ///< fastest [deg/s]
  std::optional<int> slider; ///< of a list, counted from 1
  bool trains = false;       ///< true if an option is given that only a training has a use for
  int threads = 0;
  bool overwrite = false;
  LogFormat log = LogFormat::automatic;
};

using Command =
    std::variant<InitOptions, CheckOptions, RunOptions, SweepOptions, FitOptions,
                 UncertaintyOptions, DesignOptions, GenerateOptions, MotionOptions,
                 ImpedanceOptions, LiveOptions, ReportOptions, CompareOptions, VerifyOptions,
                 StudioOptions, DoctorOptions, CiteOptions, ClusterOptions, KeysOptions,
                 CompletionOptions, ManualOptions, CacheOptions>;

} // namespace ionskin::apps
