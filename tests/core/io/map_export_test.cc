// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/map_export.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

/// Three cells in two rows: below occupied, undecided, free; above unknown, hit once, and 0.197.
OccupancyMap SmallMap() {
  const float unknown = std::nanf("");
  return {0.05, CellBox{{-10, 20}, 3, 2}, {0.99f, 0.5f, 0.01f, unknown, 0.7f, 0.197f}};
}

std::vector<int> PixelsOf(const std::string& pgm, int count) {
  std::vector<int> pixels;
  for (const char c : pgm.substr(pgm.size() - count))
    pixels.push_back(static_cast<unsigned char>(c));
  return pixels;
}

TEST(MapExport, WritesTrinaryPixelsFromTheTop) {
  const TemporaryFolder folder;
  const MapFiles files = ExportMap(SmallMap(), MapPixels::kTrinary, folder.Path("map.pgm"));
  const std::string pgm = ContentOf(files.image);
  EXPECT_THAT(pgm, HasSubstr("\n3 2\n255\n"));
  EXPECT_EQ(pgm.substr(0, 3), "P5\n");
  EXPECT_THAT(PixelsOf(pgm, 6), ElementsAre(205, 0, 205, 0, 205, 254));
}

TEST(MapExport, KeepsGreysAndNoneOfThemIsThatOfTheUnknown) {
  const TemporaryFolder folder;
  const MapFiles files = ExportMap(SmallMap(), MapPixels::kGreys, folder.Path("map.pgm"));
  EXPECT_THAT(PixelsOf(ContentOf(files.image), 6), ElementsAre(205, 77, 204, 3, 128, 252));
  EXPECT_THAT(ContentOf(files.yaml), HasSubstr("mode: trinary\n"));
}

TEST(MapExport, PutsTheOriginAtTheLowerLeftCorner) {
  const TemporaryFolder folder;
  const MapFiles files = ExportMap(SmallMap(), MapPixels::kTrinary, folder.Path("map.yaml"));
  EXPECT_EQ(ContentOf(files.yaml),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-0.525000, 0.975000, 0]\n"
            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapExport, NamesBothFilesAfterThePath) {
  const TemporaryFolder folder;
  for (const char* name : {"map", "map.pgm", "map.yaml"}) {
    const MapFiles files = ExportMap(SmallMap(), MapPixels::kTrinary, folder.Path(name));
    EXPECT_THAT(files.image, EndsWith("/map.pgm"));
    EXPECT_THAT(files.yaml, EndsWith("/map.yaml"));
  }
  EXPECT_THAT(ExportMap(SmallMap(), MapPixels::kTrinary, folder.Path("v1.2")).image,
              EndsWith("/v1.2.pgm"));
}

TEST(MapExport, ThrowsWhereItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      MessageOf([&] { ExportMap(SmallMap(), MapPixels::kTrinary, folder.Path("none/map.pgm")); }),
      HasSubstr("none/map.pgm: cannot be written"));
}

}  // namespace
}  // namespace loopscope
