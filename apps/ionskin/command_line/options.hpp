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

/// Form in which a command shows its progress on stderr. `automatic`: a bar on a terminal and lines
/// elsewhere. `none`: no progress. `quiet`: neither progress nor a summary of the results.
enum class LogFormat { automatic, bar, lines, json, none, quiet };

/// Options of `ionskin run`.
struct RunOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  int threads = 0; ///< 0: all processors
  bool overwrite = false;
  bool resume = false;
  bool no_report = false;
  bool figures = false; ///< true to write the report's figures as files, too
  std::string only;     ///< studies to run: "mechanics", "electrochemistry" or empty for both
  LogFormat log = LogFormat::automatic;
};

/// Options of `ionskin sweep`.
struct SweepOptions {
  std::string case_path;
  std::string output;
  /// Swept keys: "KEY=first:step:last", "KEY=value,value" or "KEY=a:b".
  std::vector<std::string> over;
  std::vector<std::string> set_edits;
  std::size_t samples = 0; ///< number of sampled points; 0: the points of a grid
  std::string sampling = "sobol";
  std::uint64_t seed = 1;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  bool no_report = false;
  bool figures = false; ///< true to write the report's figures as files, too
  std::string only;     ///< studies to run: "mechanics", or empty for both
  bool explain = false; ///< true to print the cost of the sweep only
  bool plan = false;    ///< true to write plan.json only
  /// Number of the batch of a planned sweep to run; nullopt: the whole sweep.
  std::optional<std::size_t> batch;
  bool collect = false; ///< true to write the tables of a planned sweep only
  std::string on;       ///< scheduler file of the cluster to run on; empty for this machine
  LogFormat log = LogFormat::automatic;
};

/// Options of `ionskin cluster`.
struct ClusterOptions {
  std::string action;                ///< "start", "worker" or "stop"
  std::string folder;                ///< folder of the cluster, with its scheduler.json
  std::string address = "127.0.0.1"; ///< address at which the scheduler listens
  bool tls = false;                  ///< true to encrypt and authenticate connections
  int workers = 1, threads = 0; ///< workers on this machine, and threads; 0 threads: all processors
  double memory = 0;            ///< memory of a worker [bytes]; 0: all that is free
  double death_timeout = 60;    ///< time that a worker waits for the scheduler [s]
};

/// Options of `ionskin fit`.
struct FitOptions {
  std::string case_path, data_path, output;
  std::vector<std::string> free; ///< keys to fit, each a name or several with commas
  std::string column;            ///< column of the data to fit; empty when only one can be fitted
  std::vector<std::string> set_edits;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  LogFormat log = LogFormat::automatic;
};

/// Options that `ionskin uncertainty`, `design` and `generate` share; ionskin's Python package
/// carries these verbs out.
struct TrialOptions {
  std::string case_path, output;
  std::string on; ///< scheduler file of the cluster to run on; empty for this machine
  std::vector<std::string> set_edits;
  int threads = 0;
  bool overwrite = false;
  bool resume = false;
  bool quiet = false; ///< true to print errors only
};

/// Options of `ionskin uncertainty`.
struct UncertaintyOptions : TrialOptions {
  std::vector<std::string> vary; ///< "KEY=DISTRIBUTION"
  std::size_t samples = 64;
  std::string design = "sobol"; ///< "sobol" or "lhs" (Latin hypercube)
  std::uint64_t seed = 1;
  std::vector<std::string> metrics; ///< metrics to analyse; empty for the usual ones
  /// Least predictive coefficient Q2 of a surrogate that is used, in (0, 1).
  double least_q2 = 0.95;
};

/// Options of `ionskin design`.
struct DesignOptions : TrialOptions {
  std::vector<std::string> free, subject_to; ///< "KEY=lowest:highest unit", "METRIC < value"
  std::string maximise, minimise; ///< name of the metric, in one of the two; the other is empty
  std::size_t budget = 60;        ///< largest number of evaluations
  std::uint64_t seed = 1;
};

/// Options of `ionskin generate`.
struct GenerateOptions : TrialOptions {
  /// "KEY=DISTRIBUTION", beside the random finger and its motion, or in place of them.
  std::vector<std::string> vary;
  std::size_t touches = 0; ///< number of touches
  std::size_t balance = 0; ///< rows of each kind of moving contact to choose at most; 0 for none
  std::uint64_t seed = 1;
};

/// Options of `ionskin motion`, which makes a path of waypoints from recordings; ionskin's Python
/// package carries it out. Quantities are texts as the user wrote them; an empty text is a default.
struct MotionOptions {
  std::vector<std::string> recordings;
  std::string output;
  std::vector<std::string> columns; ///< "ROLE=NAME" or "ROLE=NAME [unit]"
  std::string origin, x_axis, y_axis, tool, force_in = "skin", level = "auto";
  std::string contact_force, gap, rate, filter;
  bool tare = false;
  bool angles = false; ///< true for a path with roll, pitch and yaw
  bool overwrite = false;
  bool quiet = false;
};

/// Options of `ionskin report`.
struct ReportOptions {
  std::string folder;               ///< output folder of a run or a sweep
  std::vector<std::string> figures; ///< names of the figures to write as files; empty for the page
  bool files = false;               ///< true to write every figure as a file, too
  bool claims = false;              ///< true to judge the article's claims even for another case
  LogFormat log = LogFormat::automatic;
};

/// Options of `ionskin compare`.
struct CompareOptions {
  std::string first, second; ///< output folders of the two runs
  double tolerance = 1e-9;   ///< largest relative difference [1] that counts as equal
};

/// Options of `ionskin studio`.
struct StudioOptions {
  std::string folder = "."; ///< folder of cases and results to work in
  int port = 0;             ///< TCP port of 127.0.0.1; 0: any free port
  bool no_browser = false;  ///< true to open no browser
};

/// `ionskin doctor` has no options.
struct DoctorOptions {};
/// `ionskin man` has no options.
struct ManualOptions {};

/// Options of `ionskin verify`.
struct VerifyOptions {
  /// "mechanics", "electrochemistry", "poroelasticity", "chain", or empty for all.
  std::string part;
  std::string csv; ///< file for the table; empty for none
  int threads = 0;
};

/// Options of `ionskin impedance`.
struct ImpedanceOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  std::string from, to; ///< lowest and highest frequency, with unit
  int points = 10;      ///< frequencies per decade
  bool overwrite = false;
};

/// Options of `ionskin live`, which trains a reduced-order (live) skin.
struct LiveOptions {
  std::string case_path; ///< case file; or, to export an FMU only, file of a skin that was trained
  std::string output;    ///< file of the trained skin; empty to write an FMU only
  std::string fmu;       ///< file of the FMU; empty for none
  std::vector<std::string> set_edits;
  std::size_t trajectories = 12; ///< number of random touches to train on
  std::size_t validation = 90;   ///< number of other random touches that measure the errors
  std::uint64_t seed = 1;
  /// Lowest and highest coefficient of friction to train; nullopt: only the case's.
  std::optional<std::array<double, 2>> friction;
  double tilt = 0;           ///< largest tilt of the slider to train [deg]
  double spin = 0;           ///< largest rate of turn about z to train [deg/s]
  std::optional<int> slider; ///< slider of a list [[slider]] to train, counted from 1
  bool trains = false;       ///< true if an option is given that only training uses
  int threads = 0;
  bool overwrite = false, resume = false;
  LogFormat log = LogFormat::automatic;
};

/// Options of the verb that the user gave; the type of the options says which verb it is.
using Command =
    std::variant<InitOptions, CheckOptions, RunOptions, SweepOptions, FitOptions,
                 UncertaintyOptions, DesignOptions, GenerateOptions, MotionOptions,
                 ImpedanceOptions, LiveOptions, ReportOptions, CompareOptions, VerifyOptions,
                 StudioOptions, DoctorOptions, CiteOptions, ClusterOptions, KeysOptions,
                 CompletionOptions, ManualOptions, CacheOptions>;

} // namespace ionskin::apps
