// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/interrupt.h"

namespace c1mesh::app {
namespace {

constexpr int kGlance = 100;  // milliseconds between looks at the clock and for signals
constexpr std::chrono::seconds kLastWords(3);

// Signals by which a program ends itself: the same input will do the same again. All others come
// from outside (a person, a scheduler, a machine short of memory).
bool own_fault(int signal) {
  for (const int own : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGTRAP, SIGSYS})
    if (signal == own) return true;
  return false;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Pool::Pool(const BatchOptions& options, Heard heard)
    : options_(options), heard_(std::move(heard)) {}

void Pool::work(const std::vector<BatchInput>& inputs) {
  std::size_t next = 0;
  Clock::time_point asked_to_stop{};
  while (true) {
    if (interrupted() && asked_to_stop == Clock::time_point{}) {
      asked_to_stop = Clock::now();
      stop_all();
    }
    const bool stopping = asked_to_stop != Clock::time_point{};
    while (!stopping && next < inputs.size() &&
           working_.size() < static_cast<std::size_t>(options_.jobs)) {
      Work& work = working_.emplace_back();
      work.input = inputs[next++];
      start(work);
    }
    if (working_.empty()) return;
    std::vector<pollfd> pipes;
    for (const Work& work : working_) pipes.push_back({work.child.pipe, POLLIN, 0});
    const int ready = poll(pipes.data(), pipes.size(), kGlance);
    std::size_t k = 0;
    for (auto work = working_.begin(); work != working_.end(); ++k) {
      if (stopping && Clock::now() - asked_to_stop > kLastWords) kill(work->child.process, SIGKILL);
      look_at_clock(*work);
      const bool open = ready <= 0 || pipes[k].revents == 0 || listen(*work);
      if (open || !bury(*work))
        ++work;
      else
        work = working_.erase(work);
    }
  }
}

void Pool::start(Work& work) {
  work.child = start_child(work.input, options_, work.begun);
  work.since = Clock::now();
  work.heard.clear();
}

// False: the child has closed its end.
bool Pool::listen(Work& work) {
  char block[1 << 16];
  const ssize_t count = read(work.child.pipe, block, sizeof block);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  work.heard.append(block, static_cast<std::size_t>(count));
  for (std::size_t end; (end = work.heard.find('\n')) != std::string::npos;) {
    hear(work, Json::parse(work.heard.substr(0, end)));
    work.heard.erase(0, end + 1);
  }
  return count > 0;
}

void Pool::hear(Work& work, const Json& line) {
  Finished& finished = work.end.finished;
  if (line.contains("key")) finished.key = line["key"];
  if (line.contains("end")) work.ended = true;
  if (line.contains("stopped")) work.stopped = true;
  if (line.contains("begin")) {
    work.drawing = line["begin"];
    ++work.begun;
    work.since = Clock::now();
  }
  if (line.contains("record")) {
    work.drawing.clear();
    finished.records.push_back(line["record"]);
    finished.seconds.push_back(line["seconds"]);
    for (const Json& file : line["files"]) finished.files.push_back(file);
    if (!line["for_good"]) work.end.for_good = false;
  }
}

void Pool::look_at_clock(Work& work) {
  const double patience = options_.patience();
  if (patience <= 0 || work.out_of_time) return;
  const std::chrono::duration<double> taken = Clock::now() - work.since;
  if (taken.count() < patience) return;
  work.out_of_time = true;
  kill(work.child.process, SIGKILL);
}

// The child is gone. False: another one does the drawings that are left.
bool Pool::bury(Work& work) {
  close(work.child.pipe);
  const int status = wait_for(work.child.process);
  if (WIFSIGNALED(status)) remove_leftovers(options_.run.folder, {work.input});
  if (work.stopped || (interrupted() && !work.ended)) return true;  // not done, and not a failure
  if (!work.ended) {
    record_end(work, status);
    const bool more = !work.drawing.empty();
    work.drawing.clear();
    work.out_of_time = false;
    if (more) {
      start(work);
      return false;
    }
  }
  heard_(work.end);
  return true;
}

// The shape that was in work when its process ended without a word, as a failure.
void Pool::record_end(Work& work, int wait_status) {
  const std::string name = work.drawing.empty() ? work.input.stem : work.drawing;
  Status status = Status::internal;
  std::string message;
  if (work.out_of_time) {
    status = Status::limit;
    message = fmt::format("ended after {} seconds", options_.patience());
  } else if (WIFSIGNALED(wait_status)) {
    const int signal = WTERMSIG(wait_status);
    message = fmt::format("internal error: ended by signal {} ({})", signal, strsignal(signal));
    if (!own_fault(signal)) work.end.for_good = false;
    if (signal == SIGKILL) message += "; perhaps the memory ran out";
  } else {
    message = fmt::format("internal error: ended with status {}", WEXITSTATUS(wait_status));
  }
  work.end.finished.records.push_back(failure_record(work.input, name, status, message));
  work.end.finished.seconds.push_back(
      std::chrono::duration<double>(Clock::now() - work.since).count());
}

void Pool::stop_all() {
  for (const Work& work : working_) kill(work.child.process, SIGTERM);
}

}  // namespace c1mesh::app
