// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture_comparison.h"

#include <cassert>

#include <opencv2/core.hpp>

namespace loopscope {
namespace {

/// The pixels of `picture`, which has to live longer.
cv::Mat AsMat(const Picture& picture) {
  return cv::Mat(picture.height, picture.width, CV_8UC3,
                 const_cast<std::uint8_t*>(picture.rgb.data()));
}

cv::Mat AbsoluteDifference(const Picture& a, const Picture& b) {
  cv::Mat difference;
  cv::absdiff(AsMat(a), AsMat(b), difference);
  return difference;
}

}  // namespace

PictureComparison Compare(const Picture& actual, const Picture& expected,
                          const PictureTolerance& tolerance) {
  PictureComparison result;
  result.same_size = actual.width == expected.width && actual.height == expected.height;
  if (!result.same_size) return result;
  if (actual == expected) return {true, 0.0, 0, true};
  const cv::Mat difference = AbsoluteDifference(actual, expected);
  cv::Mat channels = difference.reshape(1, static_cast<int>(difference.total()));
  cv::Mat largest;  // of the three channels of each pixel
  cv::reduce(channels, largest, 1, cv::REDUCE_MAX);
  double max_difference = 0.0;
  cv::minMaxLoc(largest, nullptr, &max_difference);
  result.max_difference = static_cast<int>(max_difference);
  result.differing_share =
      cv::countNonZero(largest > tolerance.max_level) / static_cast<double>(largest.total());
  result.equal = result.differing_share <= tolerance.max_share;
  return result;
}

Picture DifferencePicture(const Picture& a, const Picture& b) {
  assert(a.width == b.width && a.height == b.height);
  constexpr double kGain = 8.0;
  Picture difference{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
  AbsoluteDifference(a, b).convertTo(AsMat(difference), CV_8UC3, kGain);
  return difference;
}

void WriteComparison(const Picture& actual, const Picture& expected, const std::string& folder,
                     const std::string& name) {
  const std::string stem = folder + "/" + name;
  WritePng(actual, stem + ".actual.png");
  WritePng(expected, stem + ".expected.png");
  if (actual.width == expected.width && actual.height == expected.height) {
    WritePng(DifferencePicture(actual, expected), stem + ".difference.png");
  }
}

}  // namespace loopscope
