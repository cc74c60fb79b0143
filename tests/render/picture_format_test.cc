// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture_format.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(PictureFormatOfTest, IsTheEndOfTheName) {
  EXPECT_EQ(PictureFormatOf("a/b.png"), PictureFormat::kPng);
  EXPECT_EQ(PictureFormatOf("b.png.SVG"), PictureFormat::kSvg);
  EXPECT_EQ(PictureFormatOf("b.pdf"), PictureFormat::kPdf);
}

TEST(PictureFormatOfTest, OtherNamesAreRefusedWithTheKnownOnes) {
  for (const std::string path : {"a.bmp", "png", "a.svg/b"}) {
    try {
      PictureFormatOf(path);
      FAIL() << "nothing was thrown for " << path;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), path + ": expected a name that ends in .png, .svg or .pdf");
    }
  }
}

}  // namespace
}  // namespace loopscope
