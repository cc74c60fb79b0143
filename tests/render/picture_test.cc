// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

Picture Ramp() {
  Picture picture{7, 5, std::vector<std::uint8_t>(3 * 7 * 5)};
  std::iota(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{1});
  return picture;
}

TEST(PngTest, APictureSurvivesItsFile) {
  const TemporaryFolder folder;
  WritePng(Ramp(), folder.Path("ramp.png"));
  EXPECT_EQ(ReadPng(folder.Path("ramp.png")), Ramp());
}

TEST(PngTest, TheSamePictureGivesTheSameBytes) {
  EXPECT_EQ(EncodePng(Ramp()), EncodePng(Ramp()));
  EXPECT_EQ(EncodePng(Ramp()).substr(1, 3), "PNG");
}

TEST(PngTest, AFileThatIsNoPngIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("not_a.png", "P5 7 5 255");
  EXPECT_EQ(MessageOf([&] { ReadPng(path); }), path + ": expected a PNG image");
  EXPECT_THROW(ReadPng(folder.Path("missing.png")), FileError);
}

TEST(PngTest, AFolderThatIsNotThereIsReportedByName) {
  const TemporaryFolder folder;
  EXPECT_THROW(WritePng(Ramp(), folder.Path("no/such/folder/x.png")), FileError);
}

}  // namespace
}  // namespace loopscope
