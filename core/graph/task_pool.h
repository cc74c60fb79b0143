// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace loopscope {

/// Runs tasks on background threads, begun in the order in which they were added.
class TaskPool {
 public:
  /// `num_threads` is at least 1.
  explicit TaskPool(int num_threads);
  /// Tasks not yet begun are dropped.
  ~TaskPool();
  TaskPool(const TaskPool&) = delete;
  TaskPool& operator=(const TaskPool&) = delete;

  void Add(std::function<void()> task);

  /// Returns when all tasks that were added are done. Throws the first exception of these.
  void Wait();

 private:
  void Work();

  std::mutex mutex_;
  std::condition_variable task_added_;
  std::condition_variable task_done_;
  std::deque<std::function<void()>> waiting_;
  int num_unfinished_ = 0;
  std::exception_ptr error_;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace loopscope
