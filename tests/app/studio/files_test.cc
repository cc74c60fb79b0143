// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <unistd.h>

#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

class FilesTest : public WindowFixture {
 protected:
  /// Opens a file beside an open recording, and expects one readable message and nothing else.
  void ExpectMessage(const std::string& path, const std::string& part) {
    OpenSmallLoop();
    Play({"step.seek 30"});
    window().Run("file.open " + path);
    WaitUntilIdle();
    EXPECT_THAT(window().message(), testing::HasSubstr(part));
    EXPECT_THAT(window().message(), testing::HasSubstr(path));
    EXPECT_THAT(window().message(), testing::Not(testing::HasSubstr("\n")));
    EXPECT_EQ(session().path(), SmallLoopRecording());
    EXPECT_EQ(state().step, 30);
    window().Run("step.next");
    WaitUntilIdle();
    EXPECT_EQ(state().step, 31) << "the window goes on";
  }
};

TEST_F(FilesTest, AMissingFileIsTold) {
  ExpectMessage(folder().Path("missing.loopscope"), "No such file");
}

TEST_F(FilesTest, AnEmptyFileIsTold) { ExpectMessage(folder().Write("empty.log", ""), ""); }

TEST_F(FilesTest, ABinaryFileIsTold) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  ExpectMessage(folder().Write("binary.log", bytes), "");
}

TEST_F(FilesTest, ATruncatedRecordingIsTold) {
  const std::string content = ContentOf(SmallLoopRecording());
  ExpectMessage(folder().Write("half.loopscope", content.substr(0, content.size() / 2)), "");
}

TEST_F(FilesTest, ARecordingOfANewerSchemaIsTold) {
  std::string content = ContentOf(SmallLoopRecording());
  content.at(63) = 99;  // the last byte of SQLite's user version
  ExpectMessage(folder().Write("newer.loopscope", content), "made by a newer Loopscope");
}

TEST_F(FilesTest, AFolderIsTold) { ExpectMessage(folder().Path(""), ""); }

TEST_F(FilesTest, AFileThatMustNotBeReadIsTold) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read all files";
  const std::string path = folder().Write("secret.log", "FLASER 0\n");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  ExpectMessage(path, "Permission denied");
}

TEST_F(FilesTest, ARecordingThatCannotBeWrittenIsTold) {
  const std::string log = CopyOfLog();
  std::filesystem::create_directories(folder().Path("small_loop.loopscope.part/full"));
  window().Run("file.open " + log);
  WaitUntilIdle();
  EXPECT_THAT(window().message(), testing::HasSubstr("small_loop.loopscope"));
}

TEST_F(FilesTest, TheMessageGoesWhenAFileIsOpened) {
  window().Run("file.open " + folder().Path("missing.log"));
  WaitUntilIdle();
  EXPECT_NE(window().message(), "");
  ExpectWindow("message");
  OpenSmallLoop();
  EXPECT_EQ(window().message(), "");
}

TEST_F(FilesTest, ACommandThatMakesNoSenseIsTold) {
  OpenSmallLoop();
  window().Run("step.sek 3");
  EXPECT_THAT(window().message(), testing::HasSubstr("there is step.seek"));
  window().Run("step.seek three");
  EXPECT_THAT(window().message(), testing::HasSubstr("expected a whole number"));
}

}  // namespace
}  // namespace loopscope
