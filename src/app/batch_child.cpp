// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/limits.h"
#include "app/road.h"

namespace c1mesh::app {
namespace {

/// The errors of one shape as one text: the first few, an input can have thousands.
class Messages {
 public:
  void add(const std::string& text) {
    constexpr int kShown = 10;
    if (++count_ <= kShown) text_ += (text_.empty() ? "" : "\n") + text;
    last_ = text;
  }
  std::string text() const {
    return last_.empty() || text_.ends_with(last_) ? text_ : text_ + "\n…\n" + last_;
  }

 private:
  std::string text_, last_;
  int count_ = 0;
};

Json record_of(const BatchInput& input, const std::string& name, const DrawingRun& run) {
  const Metrics& m = run.metrics;
  std::string message;
  for (const std::string& missed : run.missed) message += (message.empty() ? "" : "\n") + missed;
  return {{"input", input.path},
          {"name", name},
          {"status", static_cast<int>(run.status)},
          {"triangles", m.triangles},
          {"g", m.mips_bound_max},
          {"exceptional", m.exceptional},
          {"surplus", m.surplus},
          {"d_ei_max", m.d_ei.max},
          {"remedies", run.remedies},
          {"message", printable(message)}};
}

class Worker {
 public:
  Worker(const BatchInput& input, const BatchOptions& options, int pipe)
      : input_(input), options_(options), pipe_(pipe) {
    console_.quiet = true;
  }

  void work(std::size_t first) {
    Messages messages;
    console_.on_error = [&](const std::string& text) { messages.add(text); };
    const Status status = guarded(console_, input_.path, [&] {
      const std::vector<Drawing> drawings = read();
      for (std::size_t k = first; k < drawings.size() && !interrupted(); ++k) draw(drawings[k]);
      return Status::ok;
    });
    if (interrupted()) return say({{"stopped", true}});
    if (status != Status::ok)
      say_record(failure_record(input_, input_.stem, status, messages.text()), 0, {});
    say({{"end", true}});
  }

 private:
  std::vector<Drawing> read() {
    std::string bytes;
    try {
      bytes = read_bytes(input_.path, options_.run.read.max_bytes);
    } catch (...) {
      say({{"key", key_of(input_, "")}});
      throw;
    }
    say({{"key", key_of(input_, bytes)}});
    std::vector<Drawing> drawings = read_drawings_from(bytes, input_.stem, options_.run.read);
    if (drawings.empty()) throw FileError("there is no shape in it");
    if (drawings.size() > 1 && !input_.many())
      throw FileError("there are several shapes in it: an SVG drawing must be named .svg");
    return drawings;
  }

  void draw(const Drawing& drawing) {
    say({{"begin", drawing.name}});
    const auto start = std::chrono::steady_clock::now();
    Messages messages;
    console_.on_error = [&](const std::string& text) { messages.add(text); };
    DrawingRun run;
    bool for_good = true;  // a full disk is not the shape's fault
    const Status status = guarded(console_, drawing.name, [&] {
      try {
        run = run_drawing(console_, options_.run, input_.path, drawing);
      } catch (const WriteError&) {
        for_good = false;
        throw;
      }
      return run.status;
    });
    if (interrupted() && status == Status::limit) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const bool written = !run.files.empty();
    say_record(written ? record_of(input_, drawing.name, run)
                       : failure_record(input_, drawing.name, status, messages.text()),
               seconds.count(), run.files, for_good);
  }

  void say_record(const Json& record, double seconds, const std::vector<std::string>& paths,
                  bool for_good = true) {
    Json files = Json::array();
    for (const std::string& path : paths)
      files.push_back(path.substr(options_.run.folder.size() + 1));
    say({{"record", record}, {"seconds", seconds}, {"files", files}, {"for_good", for_good}});
  }

  // If nobody listens any more, there is nothing left to do.
  void say(const Json& json) {
    const std::string text = line_of(json) + "\n";
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t now = ::write(pipe_, text.data() + done, text.size() - done);
      if (now < 0 && errno != EINTR) _exit(static_cast<int>(Status::internal));
      if (now > 0) done += static_cast<std::size_t>(now);
    }
  }

  const BatchInput& input_;
  const BatchOptions& options_;
  int pipe_;
  Console console_;
};

// An abandoned child would go on writing beside the batch that resumes.
void die_with_parent(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, signal_to_the_abandoned());
#endif
  if (getppid() != parent) _exit(static_cast<int>(Status::internal));
}

// What libraries print before they abort; the batch itself speaks for its children.
void silence() {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
}

}  // namespace

double BatchOptions::patience() const {
  if (kill_after > 0) return kill_after;
  return run.options.time_limit > 0 ? 2 * run.options.time_limit + 10 : 0;
}

std::string key_of(const BatchInput& input, const std::string& content) {
  return hash_of(fmt::format("{}\n{}\n", input.path, input.stem)) + hash_of(content);
}

Json failure_record(const BatchInput& input, const std::string& name, Status status,
                    const std::string& message) {
  return {
      {"input", input.path},          {"name", name},        {"status", static_cast<int>(status)},
      {"triangles", nullptr},         {"g", nullptr},        {"exceptional", nullptr},
      {"surplus", nullptr},           {"d_ei_max", nullptr}, {"remedies", Json::array()},
      {"message", printable(message)}};
}

Child start_child(const BatchInput& input, const BatchOptions& options, std::size_t first) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(std::string("no more processes: ") + std::strerror(reason));
  }
  if (process > 0) {
    close(ends[1]);
    return {process, ends[0]};
  }
  close(ends[0]);
  die_with_parent(parent);
  if (!options.verbose) silence();
  limit_memory(options.memory_limit);
  Worker(input, options, ends[1]).work(first);
  _exit(0);  // no destructors: what they would tidy up is the parent's
}

}  // namespace c1mesh::app
