// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/offscreen_window.h"

#include <stdexcept>
#include <utility>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>

namespace loopscope {

vtkStandardNewMacro(OffscreenWindow);

/// Nothing is shown: pictures are read where they were rendered, so that one framebuffer is enough.
/// To allocate the others took longer than to render a map.
OffscreenWindow::OffscreenWindow() {
  SetSwapBuffers(false);
  for (vtkOpenGLFramebufferObject** unused : {&DisplayFramebuffer, &ResolveFramebuffer}) {
    (*unused)->Delete();
    *unused = RenderFramebuffer;
    RenderFramebuffer->Register(nullptr);
  }
}

OffscreenWindow::~OffscreenWindow() {
  if (context_) Finalize();  // while MakeCurrent is still ours
}

void OffscreenWindow::Open(std::unique_ptr<GlContext> context) {
  context_ = std::move(context);
  MakeCurrent();
  SetReadyForRendering(true);
  SetMultiSamples(0);
  SetOffScreenRendering(true);
  OpenGLInit();
  if (!Initialized) throw std::runtime_error("OpenGL does not start: glewInit failed");
}

void OffscreenWindow::MakeCurrent() {
  if (context_ && !context_->IsCurrent()) context_->MakeCurrent();
}

void OffscreenWindow::ReadRows(int first_row, int num_rows, vtkUnsignedCharArray* rgba) {
  constexpr int kRendered = 0;  // and not the front buffer
  GetRGBACharPixelData(0, first_row, GetSize()[0] - 1, first_row + num_rows - 1, kRendered, rgba);
}

bool OffscreenWindow::IsCurrent() { return context_ && context_->IsCurrent(); }

}  // namespace loopscope
