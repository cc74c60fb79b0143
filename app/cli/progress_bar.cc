// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/progress_bar.h"

#include <csignal>
#include <cstdio>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

namespace loopscope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 30;
constexpr auto kShowEvery = std::chrono::milliseconds(100);

volatile std::sig_atomic_t interrupted_flag = 0;

void RememberInterrupt(int) { interrupted_flag = 1; }

std::string Bar(double share) {
  std::string bar;
  for (int i = 0; i < kBarWidth; ++i) bar += i < share * kBarWidth ? "█" : "░";
  return bar;
}

}  // namespace

ProgressBar::ProgressBar()
    : is_terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_shown_() {}

ProgressBar::~ProgressBar() { End(); }

double ProgressBar::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ProgressBar::Show(const MappingProgress& progress) {
  Show(progress.num_steps, progress.num_scans,
       fmt::format("scans  {} nodes  {} submaps  {} loops  {:.0f} scans/s", progress.num_nodes,
                   progress.num_submaps, progress.num_loops, progress.num_steps / seconds()));
}

void ProgressBar::Show(int done, int total, const std::string& what) {
  const double share = static_cast<double>(done) / total;
  const std::string counts = fmt::format("{:3.0f} %  {}/{} {}", 100.0 * share, done, total, what);
  if (is_terminal_) {
    if (done != total && Clock::now() - last_shown_ < kShowEvery) return;
    last_shown_ = Clock::now();
    fmt::print(stderr, "\r{} {}\x1b[K", Bar(share), counts);
  } else {
    const int tenth = static_cast<int>(10.0 * share);
    if (tenth == last_tenth_) return;
    last_tenth_ = tenth;
    fmt::print(stderr, "{}\n", counts);
  }
}

void ProgressBar::End() {
  if (is_terminal_ && !has_ended_) fmt::print(stderr, "\n");
  has_ended_ = true;
}

InterruptGuard::InterruptGuard() {
  interrupted_flag = 0;
  std::signal(SIGINT, RememberInterrupt);
}

InterruptGuard::~InterruptGuard() { std::signal(SIGINT, SIG_DFL); }

bool InterruptGuard::interrupted() { return interrupted_flag != 0; }

}  // namespace loopscope
