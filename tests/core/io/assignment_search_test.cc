// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/assignment_search.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

// "path:line", or "nowhere".
std::string Find(const std::vector<LuaSource>& sources, const std::string& key) {
  const auto place = FindAssignment(sources, key);
  return place ? place->path + ":" + std::to_string(place->line) : "nowhere";
}

TEST(FindAssignment, FindsTheFullName) {
  EXPECT_EQ(Find({{"a", "A.y = 1\nA.x=2\n  A.x = 3 -- A.y = 3\nB.x = 4"}}, "A.x"), "a:3");
}

TEST(FindAssignment, FindsTheNameInATable) {
  EXPECT_EQ(Find({{"a", "A = {\n  b = {\n    x = 1,\n  },\n}"}}, "A.b.x"), "a:3");
  EXPECT_EQ(Find({{"a", "A = { b = { x = 1, y = 2 } }"}}, "A.b.y"), "a:1");
}

TEST(FindAssignment, TakesTheFullNameBeforeTheNameInATable) {
  EXPECT_EQ(Find({{"a", "x = 1"}, {"b", "A.x = 2"}}, "A.x"), "b:1");
}

TEST(FindAssignment, TakesTheMainSourceBeforeThoseItIncludes) {
  EXPECT_EQ(Find({{"a", "\nA.x = 1"}, {"b", "A.x = 2"}}, "A.x"), "a:2");
}

TEST(FindAssignment, TakesWholeNamesOnly) {
  EXPECT_EQ(Find({{"a", "max_x = 1\nA.max_x = 2\nx.y = 1\nC.x = 2"}}, "A.x"), "nowhere");
}

TEST(FindAssignment, PassesOverComments) {
  EXPECT_EQ(Find({{"a", "-- A.x = 1"}}, "A.x"), "nowhere");
}

}  // namespace
}  // namespace loopscope
