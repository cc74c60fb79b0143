// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/line_reader.h"

#include <zlib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> LinesOf(const std::string& path) {
  LineReader reader(path);
  std::vector<std::string> lines;
  while (const auto line = reader.Next()) lines.emplace_back(*line);
  return lines;
}

std::string WriteGzip(const TemporaryFolder& folder, const std::string& name,
                      const std::string& content) {
  gzFile file = gzopen(folder.Path(name).c_str(), "wb");
  gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
  gzclose(file);
  return folder.Path(name);
}

/// Text that gzip cannot make small.
std::string Noise(std::size_t size) {
  std::string text;
  unsigned state = 1;
  while (text.size() < size) {
    state = state * 1664525u + 1013904223u;
    text.push_back(static_cast<char>('!' + (state >> 24) % 90));
    if (text.size() % 64 == 0) text.push_back('\n');
  }
  return text;
}

TEST(LineReader, TakesLineFeedsAndCarriageReturnsOff) {
  const TemporaryFolder folder;
  EXPECT_THAT(LinesOf(folder.Write("a", "one\ntwo\r\n\nfour")),
              ElementsAre("one", "two", "", "four"));
}

TEST(LineReader, KnowsAnUnfinishedLine) {
  const TemporaryFolder folder;
  LineReader reader(folder.Write("a", "one\ntwo"));
  reader.Next();
  EXPECT_FALSE(reader.unfinished());
  reader.Next();
  EXPECT_TRUE(reader.unfinished());
  EXPECT_EQ(reader.line_number(), 2);
  EXPECT_FALSE(reader.Next());
}

TEST(LineReader, TellsGzipByContentNotByName) {
  const TemporaryFolder folder;
  EXPECT_THAT(LinesOf(WriteGzip(folder, "zipped.log", "one\ntwo\n")), ElementsAre("one", "two"));
  EXPECT_THAT(LinesOf(folder.Write("plain.log.gz", "one\ntwo\n")), ElementsAre("one", "two"));
}

TEST(LineReader, CutsALineThatIsTooLongAndGoesOnBehindIt) {
  const TemporaryFolder folder;
  const std::string zipped =
      WriteGzip(folder, "bomb.gz", std::string(40 * kMaxLineLength, 'x') + "\nshort\n");
  LineReader reader(zipped);
  EXPECT_EQ(reader.Next()->size(), kMaxLineLength);
  EXPECT_TRUE(reader.truncated());
  EXPECT_EQ(reader.Next(), "short");
  EXPECT_FALSE(reader.truncated());
}

TEST(LineReader, ReadsLinesAcrossItsBuffer) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 30000; ++i) text += "line " + std::to_string(i) + "\n";
  const std::vector<std::string> lines = LinesOf(folder.Write("a", text));
  ASSERT_EQ(lines.size(), 30000u);
  for (int i = 0; i < 30000; ++i) ASSERT_EQ(lines[i], "line " + std::to_string(i));
}

TEST(LineReader, TellsThatGzipDataEndEarly) {
  const TemporaryFolder folder;
  const std::string whole = ContentOf(WriteGzip(folder, "whole.gz", Noise(100000)));
  LineReader reader(folder.Write("half.gz", whole.substr(0, whole.size() / 2)));
  int num_lines = 0;
  while (reader.Next()) ++num_lines;
  EXPECT_GT(num_lines, 100);
  EXPECT_TRUE(reader.ends_early());
}

TEST(LineReader, ThrowsOnDamagedGzipDataWithTheLine) {
  const TemporaryFolder folder;
  std::string zipped = ContentOf(WriteGzip(folder, "whole.gz", Noise(400000)));
  for (std::size_t i = zipped.size() / 2; i < zipped.size() / 2 + 64; ++i) zipped[i] = '\xff';
  const std::string path = folder.Write("damaged.gz", zipped);
  EXPECT_THROW(LinesOf(path), FileError);
  EXPECT_THAT(MessageOf([&] { LinesOf(path); }), HasSubstr("damaged gzip data"));
}

TEST(LineReader, ThrowsOnAFileThatIsNotThereOrAFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(MessageOf([&] { LinesOf(folder.Path("none")); }), HasSubstr("No such file"));
  EXPECT_THAT(MessageOf([&] { LinesOf(folder.Path("")); }), HasSubstr("directory"));
}

}  // namespace
}  // namespace loopscope
