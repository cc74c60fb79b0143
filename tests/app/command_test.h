// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/office_excerpt.h"
#include "tests/support/program.h"

namespace loopscope {

/// Has a small run of the beginning of the bundled log, with several finished submaps.
class CommandTest : public testing::Test {
 protected:
  CommandTest() {
    folder_.Write("a.log", OfficeExcerpt(100));
    const ProgramRun run =
        Run("map a.log -o run.loopscope "
            "--set TRAJECTORY_BUILDER_2D.submaps.num_range_data=10");
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }

  ProgramRun Run(const std::string& arguments) { return RunLoopscope(folder_, arguments); }

  /// Runs what must be refused with one line that has `expected` in it.
  void ExpectRefused(const std::string& arguments, const std::string& expected) {
    const ProgramRun run = Run(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.err.find("loopscope: "), 0u) << run.err;
    EXPECT_EQ(run.err.find('\n') + 1, run.err.size()) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr(expected)) << arguments;
  }

  bool Exists(const std::string& name) { return std::filesystem::exists(folder_.Path(name)); }

  TemporaryFolder folder_;
};

}  // namespace loopscope
