// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/task_pool.h"

#include <atomic>
#include <chrono>
#include <numeric>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(TaskPool, HasRunAllTasksAfterWait) {
  for (const int num_threads : {1, 2, 4}) {
    TaskPool pool(num_threads);
    std::vector<int> results(200, 0);
    for (int i = 0; i < 200; ++i) {
      pool.Add([&results, i] { results[i] = i + 1; });
    }
    pool.Wait();
    std::vector<int> expected(200);
    std::iota(expected.begin(), expected.end(), 1);
    EXPECT_EQ(results, expected) << num_threads;
  }
}

TEST(TaskPool, BeginsTasksInTheOrderInWhichTheyWereAdded) {
  TaskPool pool(1);
  std::vector<int> order;
  for (int i = 0; i < 50; ++i) {
    pool.Add([&order, i] { order.push_back(i); });
  }
  pool.Wait();
  std::vector<int> expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(order, expected);
}

TEST(TaskPool, WaitThrowsWhatATaskThrewOnceAllAreDone) {
  TaskPool pool(2);
  std::atomic<int> num_run = 0;
  for (int i = 0; i < 10; ++i) {
    pool.Add([&num_run, i] {
      ++num_run;
      if (i == 3) throw std::bad_alloc();
    });
  }
  EXPECT_THROW(pool.Wait(), std::bad_alloc);
  EXPECT_EQ(num_run, 10);
  pool.Wait();
}

TEST(TaskPool, WaitsForNothingAtOnce) {
  TaskPool pool(2);
  pool.Wait();
  pool.Wait();
}

TEST(TaskPool, TakesTasksAgainAfterWait) {
  TaskPool pool(2);
  std::atomic<int> num_run = 0;
  for (int round = 1; round <= 20; ++round) {
    for (int i = 0; i < 5; ++i) {
      pool.Add([&num_run] { ++num_run; });
    }
    pool.Wait();
    EXPECT_EQ(num_run, 5 * round);
  }
}

TEST(TaskPool, RunsAsManyTasksAtOnceAsItHasThreads) {
  constexpr int kNumThreads = 3;
  TaskPool pool(kNumThreads);
  std::mutex mutex;
  std::condition_variable all_are_here;
  int num_here = 0;
  int num_met = 0;
  for (int i = 0; i < kNumThreads; ++i) {
    pool.Add([&] {
      std::unique_lock lock(mutex);
      if (++num_here == kNumThreads) all_are_here.notify_all();
      // None may go before all have come; the time is a way out of a pool that is broken.
      const bool met = all_are_here.wait_for(lock, std::chrono::seconds(20),
                                             [&] { return num_here == kNumThreads; });
      if (met) ++num_met;
    });
  }
  pool.Wait();
  EXPECT_EQ(num_met, kNumThreads);
}

TEST(TaskPool, LetsTheTaskThatRunsEndWhenItIsDestroyed) {
  bool done = false;
  std::atomic<bool> begun = false;
  {
    TaskPool pool(1);
    pool.Add([&] {
      begun = true;
      std::this_thread::yield();
      done = true;
    });
    while (!begun) std::this_thread::yield();
  }
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace loopscope
