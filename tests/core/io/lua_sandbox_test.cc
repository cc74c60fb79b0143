// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/lua_sandbox.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::optional<std::string> Library(const std::string& name) {
  if (name == "stock.lua") return "STOCK = {a = 1}";
  return std::nullopt;
}

// "key = value" for all that `text` returns.
std::vector<std::string> ValuesOf(const std::string& text) {
  std::vector<std::string> values;
  for (const auto& [key, value] : RunLua({"test.lua", text}, Library).values) {
    values.push_back(key + " = " + ToLua(value));
  }
  return values;
}

std::string ErrorOf(const std::string& text) {
  try {
    RunLua({"test.lua", text}, Library);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RunLua, FlattensTheTableThatIsReturned) {
  EXPECT_THAT(ValuesOf("return {b = {c = true, d = 2.5}, a = 'x', f = math.floor, [3] = 4}"),
              ElementsAre("[3] = 4", "a = \"x\"", "b.c = true", "b.d = 2.5"));
}

TEST(RunLua, Computes) {
  EXPECT_THAT(ValuesOf("local t = {} for i = 1, 3 do t.sum = (t.sum or 0) + i end "
                       "t.angle = math.rad(180) - math.pi return t"),
              ElementsAre("angle = 0", "sum = 6"));
}

TEST(RunLua, Chooses) {
  EXPECT_THAT(ValuesOf("return {a = choose(true, 1, 2), b = choose(false, 1, 2)}"),
              ElementsAre("a = 1", "b = 2"));
}

TEST(RunLua, IncludesFromTheLibrary) {
  EXPECT_THAT(ValuesOf("include 'stock.lua' return STOCK"), ElementsAre("a = 1"));
}

TEST(RunLua, IncludesWhatStandsBesideBeforeTheLibrary) {
  const std::string folder = ::testing::TempDir() + "/lua_sandbox";
  std::filesystem::create_directories(folder + "/sub");
  std::ofstream(folder + "/stock.lua") << "include 'sub/more.lua' STOCK = {a = MORE}";
  std::ofstream(folder + "/sub/more.lua") << "MORE = 7";
  const LuaRun run = RunLua({folder + "/main.lua", "include 'stock.lua' return STOCK"}, Library);
  ASSERT_EQ(run.values.size(), 1u);
  EXPECT_EQ(run.values[0].value, ConfigValue(7.0));
  ASSERT_EQ(run.sources.size(), 3u);
  EXPECT_EQ(run.sources[2].path, folder + "/sub/more.lua");
  EXPECT_EQ(run.sources[2].text, "MORE = 7");
}

TEST(RunLua, NamesFileAndLineOfErrors) {
  EXPECT_THAT(ErrorOf("x = 1\nx = = 2"), HasSubstr("test.lua:2: unexpected symbol near '='"));
  EXPECT_THAT(ErrorOf("\n\nx.y = 1"), HasSubstr("test.lua:3: attempt to index a nil value"));
  EXPECT_EQ(ErrorOf("error('no')"), "test.lua:1: no");
}

TEST(RunLua, NamesTheIncludedFileThatIsWrong) {
  const std::string folder = ::testing::TempDir() + "/lua_sandbox_error";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/wrong.lua") << "\nx =";
  try {
    RunLua({folder + "/main.lua", "include 'wrong.lua'"}, Library);
    FAIL() << "expected an exception";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/wrong.lua:2: unexpected symbol near <eof>"));
  }
}

TEST(RunLua, AsksForATable) {
  EXPECT_EQ(ErrorOf("x = 1"), "test.lua: expected \"return options\" with a table at the end");
}

TEST(RunLua, TakesErrorsThatAreNoText) {
  EXPECT_EQ(ErrorOf("error({})"), "test.lua: raised an error without text");
}

TEST(RunLua, StopsEndlessLoops) {
  EXPECT_EQ(ErrorOf("\nwhile true do end"),
            "test.lua:2: ran 200000 instructions without coming to an end");
  EXPECT_THAT(ErrorOf("function f() return f() end f()"), HasSubstr("200000 instructions"));
}

TEST(RunLua, StopsWhatNeedsTooMuchMemory) {
  EXPECT_EQ(ErrorOf("s = 'x' for i = 1, 100 do s = s .. s end"),
            "test.lua: needs more than 4 MB of memory");
  EXPECT_EQ(ErrorOf("s = 'x' for i = 1, 16 do s = s .. s end "
                    "t = {} for i = 1, 100 do t[i] = s .. i end"),
            "test.lua: needs more than 4 MB of memory");
}

TEST(RunLua, StopsEndlessRecursion) {
  EXPECT_THAT(ErrorOf("function f() f() return 1 end f()"), HasSubstr("needs more than 4 MB"));
}

TEST(RunLua, RefusesATableInItself) {
  EXPECT_THAT(ErrorOf("t = {} t.t = t return t"), HasSubstr("a table in itself"));
  // Doubles with each level.
  EXPECT_THAT(ErrorOf("t = {} for i = 1, 25 do t = {a = t, b = t} end return t"),
              HasSubstr("too many tables"));
}

class RunLuaWithout : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Names, RunLuaWithout,
                         ::testing::Values("os", "io", "package", "require", "debug", "string",
                                           "table", "coroutine", "load", "loadfile", "dofile",
                                           "pcall", "xpcall", "collectgarbage", "setmetatable",
                                           "math.random", "math.randomseed"));

TEST_P(RunLuaWithout, HasNothingOfTheName) {
  EXPECT_THAT(ValuesOf(std::string("return {there = ") + GetParam() + " ~= nil}"),
              ElementsAre("there = false"));
}

TEST(RunLua, HasNoMethodsOfStrings) {
  EXPECT_THAT(ErrorOf("return {x = ('x'):rep(1e9)}"), HasSubstr("attempt to index a string value"));
}

TEST(RunLua, TakesNoBytecode) {
  EXPECT_THAT(ErrorOf("\x1bLua"), HasSubstr("attempt to load a binary chunk"));
}

class RunLuaInclude : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Names, RunLuaInclude,
                         ::testing::Values("none.lua", "/etc/passwd", "../main.lua", "", ".",
                                           "a/../../b.lua"));

TEST_P(RunLuaInclude, FindsOnlyFilesBelowTheFolder) {
  EXPECT_EQ(ErrorOf(std::string("include '") + GetParam() + "'"),
            std::string("test.lua:1: cannot include \"") + GetParam() +
                "\": expected a file in the folder of the options file, or the name of one of "
                "Cartographer's stock files");
}

TEST(RunLua, IncludesNothingTwice) {
  EXPECT_EQ(ErrorOf("include 'stock.lua'\ninclude 'stock.lua'"),
            "test.lua:2: (stock stock.lua): included a second time");
}

}  // namespace
}  // namespace loopscope
