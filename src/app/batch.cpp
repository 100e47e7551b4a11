// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh batch: many inputs, each in a process of its own, restartable.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/batch_pool.h"
#include "app/command.h"
#include "app/interrupt.h"
#include "app/limits.h"
#include "app/validators.h"
#include "c1mesh/version.h"

namespace c1mesh::app {
namespace {
namespace fs = std::filesystem;

struct BatchArguments {
  const CLI::App* cli = nullptr;
  std::string inputs;
  std::string shard = "1/1";
  bool resume = false;
  BatchOptions options;
};

/// Everything that was found out, for the index.
struct Records {
  std::vector<std::string> index, times;
  std::array<int, 6> by_status{};
  Status worst = Status::ok;
  std::size_t inputs = 0;

  void add(const Finished& input) {
    ++inputs;
    for (std::size_t k = 0; k < input.records.size(); ++k) {
      const Json& record = input.records[k];
      index.push_back(line_of(record));
      times.push_back(line_of({{"input", record["input"]},
                               {"name", record["name"]},
                               {"seconds", input.seconds.at(k)}}));
      const int status = record["status"];
      ++by_status.at(static_cast<std::size_t>(status));
      worst = worse(worst, static_cast<Status>(status));
    }
  }
};

// The bytes of the program: another build may find another map.
std::string program_hash() {
  try {
    return hash_of(read_bytes("/proc/self/exe", std::size_t{1} << 30));
  } catch (const std::exception&) {
    return "";
  }
}

// What decides the bytes of the results.
Json journal_header(const CLI::App& cli) {
  Json header = {{"c1mesh", version()}, {"program", program_hash()}};
  const auto values =
      values_of(cli, {"INPUTS", "--output", "--jobs", "--shard", "--resume", "--help"});
  for (const auto& [name, value] : values) header[name] = value;
  return header;
}

// Results must not replace inputs: a.svg is an input's name and a picture's.
void refuse_inputs_in(const std::string& folder, const std::vector<BatchInput>& inputs) {
  std::error_code ignored;
  for (const BatchInput& input : inputs) {
    const fs::path parent = fs::path(input.path).parent_path();
    if (fs::equivalent(parent.empty() ? "." : parent, folder, ignored))
      throw std::invalid_argument(input.path + " lies in the output folder: choose another one");
  }
}

// Is this input finished: a line in the journal, for the same bytes, and its files still there?
const Finished* finished(const Journal& journal, const BatchOptions& options,
                         const BatchInput& input) {
  std::error_code ignored;
  std::string bytes;
  if (fs::exists(input.path, ignored)) {
    if (!fs::is_regular_file(input.path, ignored))
      return nullptr;  // reading it could wait for ever
    try {
      bytes = read_bytes(input.path, options.run.read.max_bytes);
    } catch (const std::exception&) {
      bytes.clear();  // as the child says that could not read it either
    }
  }
  const Finished* found = journal.find(key_of(input, bytes));
  if (found == nullptr) return nullptr;
  for (const std::string& file : found->files)
    if (!fs::exists(options.run.folder + "/" + file, ignored)) return nullptr;
  return found;
}

std::string sorted_lines(std::vector<std::string> lines) {
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string table(const Records& records) {
  constexpr std::array<const char*, 6> kMeaning = {
      "all that was asked holds", "internal error",  "wrong options", "invalid input",
      "valid, a bound is missed", "ended by a limit"};
  std::string out = fmt::format("{} inputs, {} results", records.inputs, records.index.size());
  for (const int status : {0, 4, 5, 3, 2, 1})
    if (const int count = records.by_status[static_cast<std::size_t>(status)])
      out += fmt::format("\n  {:>8}  status {}: {}", count, status,
                         kMeaning[static_cast<std::size_t>(status)]);
  return out;
}

/// One run of the command.
class Batch {
 public:
  Batch(Console& console, const BatchArguments& arguments)
      : console_(console),
        arguments_(arguments),
        options_(arguments.options),
        shard_(Shard::parse(arguments.shard)),
        inputs_(part_of(batch_inputs(arguments.inputs), shard_)) {}

  Status work() {
    create_folder(options_.run.folder);
    refuse_inputs_in(options_.run.folder, inputs_);
    Journal journal(path("journal"), journal_header(*arguments_.cli), arguments_.resume);
    remove_leftovers(options_.run.folder, inputs_);
    std::vector<BatchInput> left;
    for (const BatchInput& input : inputs_) {
      if (const Finished* done = finished(journal, options_, input))
        records_.add(*done);
      else
        left.push_back(input);
    }
    if (records_.inputs > 0)
      console_.detail(fmt::format("{} inputs were finished before", records_.inputs));
    remove_old_index(left);
    const Progress progress = console_.progress("batch");
    show(progress);
    Pool pool(options_, [&](const InputEnd& end) {
      if (end.for_good && !end.finished.key.empty()) journal.append(end.finished);
      records_.add(end.finished);
      show(progress);
    });
    pool.work(left);
    console_.clear_bar();
    return conclude();
  }

 private:
  std::string path(const std::string& name) const {
    return options_.run.folder + "/" + name + shard_.suffix() + ".jsonl";
  }

  // An index that stands is an index of everything.
  void remove_old_index(const std::vector<BatchInput>& left) const {
    std::error_code ignored;
    for (const char* name : {"index", "times"})
      if (!left.empty()) fs::remove(path(name), ignored);
  }

  void show(const Progress& progress) const {
    const int failed = records_.by_status[1] + records_.by_status[3] + records_.by_status[5];
    progress(fmt::format("{} of {} inputs{}", records_.inputs, inputs_.size(),
                         failed ? fmt::format(", {} failed", failed) : ""),
             static_cast<double>(records_.inputs) /
                 static_cast<double>(std::max<std::size_t>(1, inputs_.size())));
  }

  Status conclude() const {
    if (interrupted() && records_.inputs < inputs_.size()) {
      console_.error(
          fmt::format("stopped by a signal: {} of {} inputs are finished; --resume goes on",
                      records_.inputs, inputs_.size()));
      return Status::limit;
    }
    deliver_together({{path("times"), sorted_lines(records_.times)},
                      {path("index"), sorted_lines(records_.index)}});
    console_.say(table(records_));
    return records_.worst;
  }

  Console& console_;
  const BatchArguments& arguments_;
  const BatchOptions& options_;
  Shard shard_;
  std::vector<BatchInput> inputs_;
  Records records_;
};

Status run_batch(Console& console, BatchArguments& arguments) {
  catch_signals();
  if (arguments.options.jobs == 0)
    arguments.options.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  arguments.options.verbose = console.verbose;
  return Batch(console, arguments).work();
}

std::string check_shard(const std::string& text) {
  try {
    Shard::parse(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string check_folder(const std::string& text) {
  return text == "-" ? "must be a folder" : "";
}

}  // namespace

Command add_batch(CLI::App& app) {
  auto arguments = std::make_shared<BatchArguments>();
  BatchOptions& options = arguments->options;
  options.run.options.threads = 1;
  CLI::App* cli = app.add_subcommand("batch", "run for many inputs, in parallel and restartable");
  cli->add_option("INPUTS", arguments->inputs,
                  "A folder, or a list of paths, one per line, # for comments; -: standard input")
      ->required();
  cli->add_option("-o,--output", options.run.folder, "Folder for the results and the index")
      ->required()
      ->check(check_folder);
  cli->add_option("-j,--jobs", options.jobs, "Inputs at a time; 0: as many as cores")
      ->capture_default_str()
      ->check(CLI::Range(0, 4096));
  cli->add_option("--shard", arguments->shard, "I/N: every Nth input, from the Ith on")
      ->check(check_shard);
  cli->add_flag("--resume", arguments->resume, "Go on with what an ended batch left");
  cli->add_option(
         "--kill-after", options.kill_after,
         "Seconds after which a shape's process is killed; 0: twice the time limit and ten "
         "more, if there is one")
      ->capture_default_str()
      ->check(at_least(0));
  add_memory_limit(*cli, options.memory_limit, " for each process");
  add_run_options(*cli, options.run);
  arguments->cli = cli;
  return {cli, [arguments](Console& console) { return run_batch(console, *arguments); }};
}

}  // namespace c1mesh::app
