// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "tests/render/pictures/expect_picture.h"
#include "tests/support/program.h"

namespace loopscope {
namespace {

// What the README shows is what its first command leaves.
TEST(Screenshots, AreThePicturesOfTheDemo) {
  const TemporaryFolder folder;
  const ProgramRun run = RunLoopscope(folder, "demo -o demo");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const PictureFolders folders{LOOPSCOPE_SOURCE_DIR "/screenshots",
                               LOOPSCOPE_BINARY_DIR "/screenshots"};
  for (const char* view : {"map", "submap", "update", "match", "search", "graph"}) {
    ExpectPicture(ReadPng(folder.Path(std::string("demo/") + view + ".png")), view, folders);
  }
}

}  // namespace
}  // namespace loopscope
