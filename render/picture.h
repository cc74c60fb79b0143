// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace loopscope {

/// RGB, a byte each, row by row from the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

bool operator==(const Picture& a, const Picture& b);

/// `picture` as a PNG. The same picture gives the same bytes.
std::string EncodePng(const Picture& picture);

/// Throws FileError if the file cannot be written; what was there before stays then.
void WritePng(const Picture& picture, const std::string& path);

/// Throws FileError if there is no PNG of RGB at `path`.
Picture ReadPng(const std::string& path);

}  // namespace loopscope
