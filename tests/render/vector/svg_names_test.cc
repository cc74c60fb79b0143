// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/svg_names.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(WithOwnNamesTest, CountsImagesFromZeroInTheirOrder) {
  EXPECT_EQ(WithOwnNames(R"(<image id="image17"/><image id="image9"/><use h="#image17"/>)"),
            R"(<image id="image0"/><image id="image1"/><use h="#image0"/>)");
}

TEST(WithOwnNamesTest, LeavesTheContentOfImagesAlone) {
  const std::string svg = R"(<path d="M 1 2"/><image h="data:image/png;base64,surface7/image8="/>)";
  EXPECT_EQ(WithOwnNames(svg), svg);
}

}  // namespace
}  // namespace loopscope
