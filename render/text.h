// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <string>
#include <vector>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/palette.h"

namespace loopscope {

enum class Weight { kRegular, kMedium };

struct TextStyle {
  int size = 13;  ///< height of the font [px]
  Weight weight = Weight::kRegular;
  Color color;
};

/// Which end of a text stands at its anchor. Vertically it is centred on it.
enum class Align { kLeft, kCenter, kRight };

/// VTK's description of `style`. Throws std::runtime_error if the font is not installed.
vtkSmartPointer<vtkTextProperty> MakeTextProperty(const TextStyle& style, Align align);

/// VTK has one set of fonts for all threads. TextWidth holds this lock while it measures; a program
/// that measures on one thread and draws on another has to hold it while it draws.
std::mutex& FontLock();

/// `text` with U+FFFD for each byte that is no UTF-8, as in names of files: neither VTK nor Cairo
/// draws those.
std::string ToUtf8(const std::string& text);

/// [px]
double TextWidth(const std::string& text, const TextStyle& style);

/// `text`, or as much of its beginning as fits into `width` [px] with an ellipsis behind it; empty
/// if not even one letter fits.
std::string ShortenToFit(const std::string& text, const TextStyle& style, double width);

/// As many of `parts` as fit into `width` [px], the first ones first, joined by a middle dot. If
/// not even the first fits, it is shortened.
std::string JoinToFit(const std::vector<std::string>& parts, const TextStyle& style, double width);

/// One line of text with its anchor at (x, y) [px from the lower left of its renderer].
vtkSmartPointer<vtkTextActor> MakeText(const std::string& text, const TextStyle& style, Align align,
                                       double x, double y);

}  // namespace loopscope
