// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

TEST(TumFile, KeepsPosesToTheNanometre) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.tum");
  const Trajectory written = {{976052857.337530, Pose2(1.25, -3.125, 3.1)},
                              {976052858.0, Pose2(-1e4, 1e-3, -2.0)}};
  WriteTum(path, written);
  const Trajectory read = ReadTum(path);
  ASSERT_EQ(read.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(read[i].time, written[i].time, 1e-6);
    EXPECT_NEAR(read[i].map_from_base.x(), written[i].map_from_base.x(), 1e-9);
    EXPECT_NEAR(read[i].map_from_base.y(), written[i].map_from_base.y(), 1e-9);
    EXPECT_NEAR(read[i].map_from_base.rotation, written[i].map_from_base.rotation, 1e-9);
  }
}

TEST(TumFile, IsReadInTheOrderOfTime) {
  const TemporaryFolder folder;
  const Trajectory read = ReadTum(
      folder.Write("a.tum", "# head\n2 20 0 0 0 0 0 1\n\n1 10 0 0 0 0 0 1\n2 21 0 0 0 0 0 1\n"));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].map_from_base.x(), 10.0);
  EXPECT_EQ(read[1].map_from_base.x(), 20.0);
  EXPECT_EQ(read[2].map_from_base.x(), 21.0);
}

TEST(TumFile, RelationsAreNoTrajectory) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("a.tum", "1 0 0 0 0 0 0 1\n1.5 2.5 3.1 0.2 0 0 0 0.4\n");
  try {
    ReadTum(path);
    FAIL() << "nothing was thrown";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()), path + ":2: expected qx qy qz qw to be of length 1");
  }
}

TEST(TumFile, TheYawOfATiltedRotationIsTaken) {
  const TemporaryFolder folder;
  // Yaw of 0.6 after a roll of 0.2: q = q_z(0.6) q_x(0.2), of which the file rounds.
  const double cz = std::cos(0.3), sz = std::sin(0.3), cx = std::cos(0.1), sx = std::sin(0.1);
  std::string line = "1 0 0 0";
  for (const double q : {cz * sx, sz * sx, sz * cx, cz * cx})
    line += " " + std::to_string(1.005 * q);
  EXPECT_NEAR(ReadTum(folder.Write("a.tum", line))[0].map_from_base.rotation, 0.6, 1e-5);
}

TEST(TumFile, ThrowsOnABadLineWithItsNumber) {
  const TemporaryFolder folder;
  const std::string good = "1 0 0 0 0 0 0 1\n";
  for (const char* bad :
       {"1 0 0 0 0 0 0\n", "1 0 0 0 0 0 0 1 1\n", "1 0 0 0 nan 0 0 1\n", "abc\n"}) {
    const std::string path = folder.Write("a.tum", "# head\n" + good + bad);
    EXPECT_EQ(MessageOf([&] { ReadTum(path); }),
              path + ":3: expected eight numbers, \"time x y z qx qy qz qw\"");
  }
  EXPECT_THAT(MessageOf([&] { ReadTum(folder.Write("b.tum", "# head\n")); }), HasSubstr("empty"));
}

TEST(RelationsFile, HasTwoTimesAndAPoseALine) {
  const TemporaryFolder folder;
  const std::vector<Relation> relations = ReadRelations(
      folder.Write("a.relations", "1.5 2.5 0.31293 0.02935 0.00000  0.00000 0.00000 0.24198\n"));
  ASSERT_EQ(relations.size(), 1u);
  EXPECT_EQ(relations[0].first_time, 1.5);
  EXPECT_EQ(relations[0].second_time, 2.5);
  EXPECT_EQ(relations[0].first_from_second, Pose2(0.31293, 0.02935, 0.24198));
}

TEST(RelationsFile, ThrowsOnABadLineWithItsNumber) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("a.relations", "1 2 3\n");
  EXPECT_EQ(MessageOf([&] { ReadRelations(path); }),
            path + ":1: expected eight numbers, \"t1 t2 x y z roll pitch yaw\"");
}

}  // namespace
}  // namespace loopscope
