// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/task_pool.h"

#include <cassert>
#include <utility>

namespace loopscope {

TaskPool::TaskPool(int num_threads) {
  assert(num_threads >= 1);
  for (int i = 0; i < num_threads; ++i) threads_.emplace_back([this] { Work(); });
}

TaskPool::~TaskPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  task_added_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void TaskPool::Add(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(task));
    ++num_unfinished_;
  }
  task_added_.notify_one();
}

void TaskPool::Wait() {
  std::unique_lock lock(mutex_);
  task_done_.wait(lock, [this] { return num_unfinished_ == 0; });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void TaskPool::Work() {
  std::unique_lock lock(mutex_);
  while (true) {
    task_added_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (stopping_) return;
    const std::function<void()> task = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    std::exception_ptr error;
    try {
      task();
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (!error_) error_ = error;
    if (--num_unfinished_ == 0) task_done_.notify_all();
  }
}

}  // namespace loopscope
