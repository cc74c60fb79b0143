// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "render/picture_comparison.h"

namespace loopscope {

/// Where pictures come from and where those of failed tests go.
struct PictureFolders {
  std::string baselines;
  std::string results;
};

/// Expects `actual` to be the baseline `name`.png. Without a baseline the picture is left in the
/// results, to be looked at and copied. If it differs, both and their difference are left there.
inline void ExpectPicture(const Picture& actual, const std::string& name,
                          const PictureFolders& folders) {
  const std::string baseline = folders.baselines + "/" + name + ".png";
  std::filesystem::create_directories(folders.results);
  if (!std::filesystem::exists(baseline)) {
    const std::string candidate = folders.results + "/" + name + ".png";
    WritePng(actual, candidate);
    ADD_FAILURE() << "no baseline: look at " << candidate << " and copy it to " << baseline;
    return;
  }
  const Picture expected = ReadPng(baseline);
  const PictureComparison result = Compare(actual, expected);
  if (result.equal) return;
  WriteComparison(actual, expected, folders.results, name);
  ADD_FAILURE() << name << " is not its baseline: " << 100.0 * result.differing_share
                << " % of the pixels differ, by up to " << result.max_difference << " levels; see "
                << folders.results << "/" << name << ".*.png";
}

}  // namespace loopscope
