// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/parallel.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace loopscope {

void ParallelFor(int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  const auto worker = [&] {
    for (int i = next++; i < count; i = next++) work(i);
  };
  const int num_workers = std::min<int>(count, std::max(1u, std::thread::hardware_concurrency()));
  if (num_workers == 1) return worker();
  std::vector<std::future<void>> workers;
  for (int i = 0; i < num_workers; ++i) workers.push_back(std::async(std::launch::async, worker));
  for (std::future<void>& each : workers) each.wait();
  for (std::future<void>& each : workers) each.get();
}

}  // namespace loopscope
