// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/picture.h"

namespace loopscope {

/// How far two pictures may differ. Software OpenGL gives the same bits on processors of one maker,
/// and a few levels, or a pixel at an edge, apart on others.
struct PictureTolerance {
  int max_level = 6;          ///< of 255, in each channel, for a pixel to count as equal
  double max_share = 0.0005;  ///< of all pixels may differ by more
};

struct PictureComparison {
  bool same_size = false;
  double differing_share = 1.0;  ///< of all pixels: those that differ by more than max_level
  int max_difference = 255;      ///< [level] of any channel of any pixel
  bool equal = false;            ///< within the tolerance
};

PictureComparison Compare(const Picture& actual, const Picture& expected,
                          const PictureTolerance& tolerance = {});

/// Black where the pictures are equal, brighter the more they differ. They must have the same size.
Picture DifferencePicture(const Picture& a, const Picture& b);

/// Writes `folder`/`name`.actual.png, .expected.png and, if the sizes are equal, .difference.png.
/// Throws FileError if they cannot be written.
void WriteComparison(const Picture& actual, const Picture& expected, const std::string& folder,
                     const std::string& name);

}  // namespace loopscope
