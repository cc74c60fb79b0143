// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/film_writer.h"

#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>
#include <opencv2/videoio.hpp>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::EndsWith;

/// In one shade of red.
Picture RedPicture(std::uint8_t red, int width = 64, int height = 48) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.rgb.insert(picture.rgb.end(), {red, 0, 0});
  return picture;
}

/// The red of each frame in the middle.
std::vector<int> RedOfFrames(const std::string& path) {
  cv::VideoCapture video(path);
  std::vector<int> reds;
  for (cv::Mat bgr; video.read(bgr);) {
    reds.push_back(bgr.at<cv::Vec3b>(bgr.rows / 2, bgr.cols / 2)[2]);
  }
  return reds;
}

class FilmWriterTest : public testing::TestWithParam<const char*> {
 protected:
  bool Exists(const std::string& name) const { return std::filesystem::exists(folder_.Path(name)); }

  const TemporaryFolder folder_;
};

class VideoTest : public FilmWriterTest {};

TEST_P(VideoTest, HoldsItsFramesInTheirOrderAndColors) {
  const std::string path = folder_.Path(GetParam());
  const auto film = MakeFilmWriter(path, 10.0);
  for (const int red : {250, 150, 50}) film->Add(RedPicture(static_cast<std::uint8_t>(red)));
  film->Finish();
  const std::vector<int> reds = RedOfFrames(path);
  ASSERT_EQ(reds.size(), 3u);
  EXPECT_NEAR(reds[0], 250, 12);
  EXPECT_NEAR(reds[1], 150, 12);
  EXPECT_NEAR(reds[2], 50, 12);
  EXPECT_EQ(cv::VideoCapture(path).get(cv::CAP_PROP_FPS), 10.0);
}

TEST_P(VideoTest, LeavesOutAnOddLastRowAndColumn) {
  const std::string path = folder_.Path(GetParam());
  const auto film = MakeFilmWriter(path, 25.0);
  film->Add(RedPicture(200, 65, 49));
  film->Finish();
  const cv::VideoCapture video(path);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 64);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_HEIGHT), 48);
}

TEST_P(VideoTest, ReplacesAFileOnlyWhenItIsComplete) {
  const std::string path = folder_.Path(GetParam());
  folder_.Write(GetParam(), "old");
  {
    const auto film = MakeFilmWriter(path, 25.0);
    film->Add(RedPicture(200));
  }
  EXPECT_EQ(std::filesystem::file_size(path), 3u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.Path("")), {}), 1);
  const auto film = MakeFilmWriter(path, 25.0);
  film->Add(RedPicture(200));
  film->Finish();
  EXPECT_EQ(RedOfFrames(path).size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Formats, VideoTest, testing::Values("a.mp4", "a.avi"));

TEST_F(FilmWriterTest, AFolderHoldsAPictureForEachFrame) {
  const auto film = MakeFilmWriter(folder_.Path("new/frames/"), 25.0);
  film->Add(RedPicture(10));
  film->Add(RedPicture(20));
  film->Finish();
  EXPECT_EQ(ReadPng(folder_.Path("new/frames/frame_000000.png")), RedPicture(10));
  EXPECT_EQ(ReadPng(folder_.Path("new/frames/frame_000001.png")), RedPicture(20));
}

TEST_F(FilmWriterTest, AFolderLosesTheLaterFramesOfALongerFilm) {
  for (const int count : {4, 2}) {
    const auto film = MakeFilmWriter(folder_.Path("frames"), 25.0);
    for (int i = 0; i < count; ++i) film->Add(RedPicture(10));
    EXPECT_TRUE(count == 4 || Exists("frames/frame_000003.png"));
    film->Finish();
  }
  EXPECT_TRUE(Exists("frames/frame_000001.png"));
  EXPECT_FALSE(Exists("frames/frame_000002.png"));
  EXPECT_FALSE(Exists("frames/frame_000003.png"));
}

TEST_F(FilmWriterTest, PlacesThatCannotBeWrittenAreRefusedInOneLine) {
  const std::string path = folder_.Path("none/a.mp4");
  try {
    MakeFilmWriter(path, 25.0);
    FAIL() << "nothing was thrown";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), path + ": cannot be written: No such file or directory");
  }
  folder_.Write("file", "");
  EXPECT_THROW(MakeFilmWriter(folder_.Path("file"), 25.0), FileError);
}

TEST_F(FilmWriterTest, OtherNamesAreRefusedWithTheKnownOnes) {
  for (const std::string path : {"a.mov", ""}) {
    try {
      RequireFilmPath(path);
      FAIL() << "nothing was thrown for " << path;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), EndsWith("expected a name that ends in .mp4 or .avi, or that of "
                                         "a folder"));
    }
  }
  RequireFilmPath("frames");
  RequireFilmPath("v1.2/");
}

}  // namespace
}  // namespace loopscope
