// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/cost.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <ctime>

namespace c1mesh {
namespace {

thread_local CostLedger* recording = nullptr;
thread_local StageTimer* innermost = nullptr;

double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

void CostLedger::add(const char* stage, double wall, double cpu) {
  auto found = std::find_if(stages_.begin(), stages_.end(),
                            [&](const StageCost& cost) { return cost.stage == stage; });
  if (found == stages_.end()) found = stages_.insert(found, {stage, 0, 0});
  found->wall += wall;
  found->cpu += cpu;
}

CostRecording::CostRecording(CostLedger& ledger) : before_(recording) {
  recording = &ledger;
}

CostRecording::~CostRecording() {
  recording = before_;
}

StageTimer::StageTimer(const char* stage) : stage_(stage), ledger_(recording) {
  if (!ledger_) return;
  around_ = innermost;
  innermost = this;
  wall_ = wall_now();
  cpu_ = cpu_now();
}

StageTimer::~StageTimer() {
  if (!ledger_) return;
  const double wall = wall_now() - wall_, cpu = cpu_now() - cpu_;
  ledger_->add(stage_, wall - inner_wall_, cpu - inner_cpu_);
  innermost = around_;
  if (!around_) return;
  around_->inner_wall_ += wall;
  around_->inner_cpu_ += cpu;
}

double peak_memory() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return static_cast<double>(usage.ru_maxrss);
#else
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
#endif
}

}  // namespace c1mesh
