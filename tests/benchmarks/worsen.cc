// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a CARMEN log that is worse than the one it reads, in one way, by the throw of a dice:
//   worsen noise|drop|slip|turn|hang|jumps SEED LOG WORSE
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/io/carmen_log.h"
#include "core/io/carmen_writer.h"
#include "core/simulation/random.h"

namespace loopscope {
namespace {

// What odometry says of the way from reading `i - 1` to reading `i`, as a function of what it said
// before.
using WorseMotion = std::function<Pose2(int i, const Pose2& before_from_now)>;

void ChangeMotions(const WorseMotion& worse, ScanLog* log) {
  Pose2 before;
  for (int i = 0; i < static_cast<int>(log->odometry.size()); ++i) {
    Pose2& odom_from_base = log->odometry[i].odom_from_base;
    const Pose2 now = odom_from_base;
    if (i > 0) {
      odom_from_base = log->odometry[i - 1].odom_from_base * worse(i, before.Inverse() * now);
    }
    before = now;
  }
}

// 1 mm of noise on each range.
void AddNoise(Random* random, ScanLog* log) {
  for (LaserScan& scan : log->scans) {
    for (float& range : scan.ranges) range += static_cast<float>(random->Gaussian(0.001));
  }
}

// Every tenth scan is missing.
void DropScans(Random* random, ScanLog* log) {
  int scan = random->Below(10);
  std::vector<LaserScan> kept;
  for (LaserScan& one : log->scans) {
    if (scan++ % 10 != 0) kept.push_back(std::move(one));
  }
  log->scans = std::move(kept);
}

// The wheels are larger than odometry believes.
void Slip(Random*, ScanLog* log) {
  ChangeMotions(
      [](int, const Pose2& motion) -> Pose2 {
        return {0.9 * motion.translation, motion.rotation};
      },
      log);
}

// They are farther apart.
void TurnLess(Random*, ScanLog* log) {
  ChangeMotions(
      [](int, const Pose2& motion) -> Pose2 {
        return {motion.translation, 0.85 * motion.rotation};
      },
      log);
}

// Odometry does not change over three stretches of a fortieth of the log.
void Hang(Random* random, ScanLog* log) {
  const int num_readings = static_cast<int>(log->odometry.size());
  const int length = std::max(1, num_readings / 40);
  std::vector<bool> hangs(num_readings, false);
  for (int stretch = 0; stretch < 3; ++stretch) {
    const int first = random->Below(std::max(1, num_readings - length));
    for (int i = first; i < std::min(num_readings, first + length); ++i) hangs[i] = true;
  }
  ChangeMotions([&hangs](int i, const Pose2& motion) { return hangs[i] ? Pose2() : motion; }, log);
}

// Five times odometry is somewhere else at once.
void Jump(Random* random, ScanLog* log) {
  std::map<int, Pose2> jumps;
  for (int i = 0; i < 5; ++i) {
    const int reading = random->Below(static_cast<int>(log->odometry.size()));
    const double x = random->Uniform(-1.0, 1.0);
    const double y = random->Uniform(-1.0, 1.0);
    jumps[reading] = {x, y, DegreesToRadians(random->Uniform(-90.0, 90.0))};
  }
  ChangeMotions(
      [&jumps](int i, const Pose2& motion) {
        const auto jump = jumps.find(i);
        return jump == jumps.end() ? motion : jump->second * motion;
      },
      log);
}

int Run(int argc, char** argv) {
  const std::map<std::string, void (*)(Random*, ScanLog*)> ways = {
      {"noise", AddNoise}, {"drop", DropScans}, {"slip", Slip},
      {"turn", TurnLess},  {"hang", Hang},      {"jumps", Jump}};
  const auto way = argc == 5 ? ways.find(argv[1]) : ways.end();
  if (way == ways.end()) {
    std::cerr << "usage: worsen noise|drop|slip|turn|hang|jumps SEED LOG WORSE\n";
    return 2;
  }
  Random random(std::strtoull(argv[2], nullptr, 10));
  ScanLog log = ReadCarmenLog(argv[3]);
  way->second(&random, &log);
  WriteCarmenLog(argv[4], log);
  return 0;
}

}  // namespace
}  // namespace loopscope

int main(int argc, char** argv) {
  try {
    return loopscope::Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "worsen: " << error.what() << "\n";
    return 2;
  }
}
