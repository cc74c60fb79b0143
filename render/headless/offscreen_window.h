// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vtkGenericOpenGLRenderWindow.h>

#include "render/headless/gl_context.h"

class vtkUnsignedCharArray;

namespace loopscope {

/// A VTK render window on a context that has no window.
class OffscreenWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, vtkGenericOpenGLRenderWindow);

  /// To be called once, before anything else. Throws std::runtime_error if OpenGL does not start.
  void Open(std::unique_ptr<GlContext> context);

  /// Whether the next frames have a depth buffer, without which nothing hides what comes after it.
  void SetHasDepth(bool has_depth);

  void Start() override;
  void MakeCurrent() override;
  bool IsCurrent() override;

  /// Rows `first_row` (from the lowest one, 0) and up as they were rendered, `num_rows` of them:
  /// RGBA, row by row, in the array given, which grows as needed.
  void ReadRows(int first_row, int num_rows, vtkUnsignedCharArray* rgba);

 protected:
  OffscreenWindow();
  ~OffscreenWindow() override;

 private:
  OffscreenWindow(const OffscreenWindow&) = delete;
  void operator=(const OffscreenWindow&) = delete;

  std::unique_ptr<GlContext> context_;
  bool has_depth_ = true;
};

}  // namespace loopscope
