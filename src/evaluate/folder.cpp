// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of results and logs, as docs/battery.sh leaves it.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <set>
#include <system_error>

#include "base/parallel.h"
#include "c1mesh/error.h"
#include "c1mesh/evaluate.h"

namespace c1mesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResult = ".c1.json";
constexpr const char* kLog = ".log";

/// The names of a folder's files without these endings.
struct Names {
  std::set<std::string> results, logs;
};

/// Regular files only, hidden ones left out: a file that is being written has a hidden name.
Names names_in(const std::string& folder) {
  Names out;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string file = entry->path().filename().string();
    std::error_code ignored;
    if (file.front() == '.' || !entry->is_regular_file(ignored)) continue;
    const auto add = [&](std::set<std::string>& names, const std::string& ending) {
      if (file.size() > ending.size() && file.ends_with(ending))
        names.insert(file.substr(0, file.size() - ending.size()));
    };
    add(out.results, kResult);
    add(out.logs, kLog);
  }
  if (error == std::errc::not_enough_memory) throw std::bad_alloc();
  if (error) throw FileError(fmt::format("cannot read the folder {}: {}", folder, error.message()));
  if (out.results.empty() && out.logs.empty())
    throw FileError(fmt::format("{}: no results (NAME{}) in this folder", folder, kResult));
  return out;
}

/// The end of a log: the exit status and the seconds of the whole run.
struct Log {
  std::optional<int> status;
  std::optional<double> seconds;
};

/// The number that is all of `line` after `key`.
template <class Number>
std::optional<Number> number_after(const std::string& key, const std::string& line) {
  if (!line.starts_with(key)) return std::nullopt;
  Number value{};
  const char* end = line.data() + line.size();
  const auto read = std::from_chars(line.data() + key.size(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

Log read_log(const std::string& path) {
  Log out;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  constexpr std::streamoff kEnd = 1 << 16;  // bytes: what comes before is the run's own messages
  file.seekg(std::max<std::streamoff>(file.tellg() - std::streamoff(kEnd), 0));
  for (std::string line; std::getline(file, line);) {
    if (const auto status = number_after<int>("STATUS ", line)) out.status = status;
    if (const auto seconds = number_after<double>("WALL ", line)) out.seconds = seconds;
  }
  return out;
}

/// A drawing of several shapes has one log, NAME.log, and results NAME-ID.c1.json: the longest such
/// NAME that has no result of its own; empty if there is none.
std::string log_of_several(const Names& names, const std::string& result) {
  for (std::size_t dash = result.rfind('-'); dash != std::string::npos && dash > 0;
       dash = result.rfind('-', dash - 1)) {
    const std::string name = result.substr(0, dash);
    if (names.logs.count(name) && !names.results.count(name)) return name;
  }
  return "";
}

/// What is to be looked at: a result, or a log that has none.
struct Job {
  std::string name;
  Log log;
  bool has_result = true;
};

std::vector<Job> jobs_in(const std::string& folder, const Names& names) {
  std::vector<Job> jobs;
  std::set<std::string> with_results;
  const auto log_named = [&](const std::string& name) {
    return read_log(folder + "/" + name + kLog);
  };
  for (const std::string& name : names.results) {
    if (names.logs.count(name)) {
      with_results.insert(name);
      jobs.push_back({name, log_named(name)});
      continue;
    }
    // The status of a drawing is the worst of its shapes'; its seconds are those of all together.
    const std::string several = log_of_several(names, name);
    jobs.push_back({name, several.empty() ? Log{} : Log{log_named(several).status, {}}});
    if (!several.empty()) with_results.insert(several);
  }
  constexpr int kBoundMissed = 4;  // with 0 the statuses that leave a result for every shape
  for (const std::string& name : names.logs) {
    const Log log = log_named(name);
    const bool complete = log.status == 0 || log.status == kBoundMissed;
    if (names.results.count(name) || (with_results.count(name) && complete)) continue;
    jobs.push_back({name, log, false});
  }
  return jobs;
}

ShapeEvaluation evaluate_file(const std::string& path, std::size_t max_bytes) {
  ShapeEvaluation out;
  try {
    return evaluate(read_result(path, max_bytes));
  } catch (const InputError& error) {
    out.fault = error.what();
  } catch (const FileError& error) {
    out.fault = error.what();
  }
  out.unreadable = true;
  return out;
}

ShapeEvaluation without_result(const Log& log) {
  ShapeEvaluation out;
  out.fault = log.status ? fmt::format("no result; the run ended with status {}", *log.status)
                         : "no result; the log tells no status";
  return out;
}

}  // namespace

Series evaluate_folder(const std::string& folder, const std::string& label, int threads,
                       std::size_t max_bytes) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  threads > 0 ? threads : tbb::info::default_concurrency());
  const std::vector<Job> jobs = jobs_in(folder, names_in(folder));
  std::vector<ShapeEvaluation> shapes(jobs.size());
  const auto one = [&](std::size_t i) {
    const Job& job = jobs[i];
    shapes[i] = job.has_result ? evaluate_file(folder + "/" + job.name + kResult, max_bytes)
                               : without_result(job.log);
    shapes[i].name = job.name;
    shapes[i].status = job.log.status;
    shapes[i].seconds = job.log.seconds;
  };
  parallel_for(jobs.size(), one, 1);  // a result takes many milliseconds
  return make_series(label, std::move(shapes));
}

}  // namespace c1mesh
