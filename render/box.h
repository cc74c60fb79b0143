// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace loopscope {

/// A rectangle of a picture [px]; y points up.
struct Box {
  double left = 0.0;
  double bottom = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double top() const { return bottom + height; }
  double center_x() const { return left + 0.5 * width; }
  double center_y() const { return bottom + 0.5 * height; }
  bool empty() const { return width <= 0.0 || height <= 0.0; }
};

/// Whether two boxes share more than an edge.
inline bool Overlap(const Box& a, const Box& b) {
  constexpr double kRounding = 1e-6;  // [px] of the sums that right() and top() are
  return a.left + kRounding < b.right() && b.left + kRounding < a.right() &&
         a.bottom + kRounding < b.top() && b.bottom + kRounding < a.top();
}

inline Box Shrunk(const Box& box, double margin) {
  return {box.left + margin, box.bottom + margin, std::max(0.0, box.width - 2.0 * margin),
          std::max(0.0, box.height - 2.0 * margin)};
}

// A layout cuts strips off a box until it is used up. Each function returns the strip, and leaves
// the rest in `box`; a strip is never larger than what there is.

inline Box CutTop(double height, Box* box) {
  const double h = std::min(height, box->height);
  box->height -= h;
  return {box->left, box->top(), box->width, h};
}

inline Box CutBottom(double height, Box* box) {
  const double h = std::min(height, box->height);
  const Box strip{box->left, box->bottom, box->width, h};
  box->bottom += h;
  box->height -= h;
  return strip;
}

inline Box CutLeft(double width, Box* box) {
  const double w = std::min(width, box->width);
  const Box strip{box->left, box->bottom, w, box->height};
  box->left += w;
  box->width -= w;
  return strip;
}

inline Box CutRight(double width, Box* box) {
  const double w = std::min(width, box->width);
  box->width -= w;
  return {box->right(), box->bottom, w, box->height};
}

}  // namespace loopscope
