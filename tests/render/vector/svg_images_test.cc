// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/svg_images.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(WithFinishedImagesTest, CountsImagesFromZeroInTheirOrder) {
  EXPECT_EQ(
      WithFinishedImages(R"svg(<image id="image17"/><image id="image9"/><use h="#image17"/>)svg"),
      R"svg(<image id="image0"/><image id="image1"/><use h="#image0"/>)svg");
}

TEST(WithFinishedImagesTest, LeavesTheContentOfImagesAlone) {
  const std::string svg =
      R"svg(<path d="M 1 2"/><image h="data:image/png;base64,surface7/image8="/>)svg";
  EXPECT_EQ(WithFinishedImages(svg), svg);
}

TEST(WithFinishedImagesTest, KeepsOnlyEnlargedPixelsSharp) {
  EXPECT_EQ(WithFinishedImages(R"svg(<use h="#image3" transform="matrix(0,-2.5,2.5,0,7,8)"/>)svg"),
            R"svg(<use h="#image0" style="image-rendering:pixelated" )svg"
            R"svg(transform="matrix(0,-2.5,2.5,0,7,8)"/>)svg");
  const std::string reduced = R"svg(<use h="#image0" transform="matrix(0.5,0,0,0.5,7,8)"/>)svg";
  EXPECT_EQ(WithFinishedImages(reduced), reduced);
}

}  // namespace
}  // namespace loopscope
