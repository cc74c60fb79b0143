// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/flat_pass.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

namespace loopscope {

vtkStandardNewMacro(FlatPass);

void FlatPass::Render(const vtkRenderState* state) {
  vtkWindow* const window = state->GetRenderer()->GetRenderWindow();
  vtkOpenGLState* const gl = vtkOpenGLRenderWindow::SafeDownCast(window)->GetState();
  const vtkOpenGLState::ScopedglEnableDisable depth_test(gl, GL_DEPTH_TEST);
  gl->vtkglDisable(GL_DEPTH_TEST);
  pass_->Render(state);
  NumberOfRenderedProps = pass_->GetNumberOfRenderedProps();
}

void FlatPass::ReleaseGraphicsResources(vtkWindow* window) {
  pass_->ReleaseGraphicsResources(window);
}

}  // namespace loopscope
