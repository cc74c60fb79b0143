// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

namespace loopscope {

/// Draws as another pass does, but without depth: nothing is hidden by what was drawn before. So
/// nobody has to clear the depth of a window, which takes software as long as to draw a map.
class FlatPass : public vtkRenderPass {
 public:
  static FlatPass* New();
  vtkTypeMacro(FlatPass, vtkRenderPass);

  /// Must be called before anything is drawn.
  void SetPass(vtkSmartPointer<vtkRenderPass> pass) { pass_ = std::move(pass); }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 private:
  vtkSmartPointer<vtkRenderPass> pass_;
};

}  // namespace loopscope
