// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/offscreen_window.h"

#include <stdexcept>
#include <utility>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

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

void OffscreenWindow::SetHasDepth(bool has_depth) {
  if (has_depth == has_depth_) return;
  has_depth_ = has_depth;
  MakeCurrent();
  RenderFramebuffer->ReleaseGraphicsResources(this);
}

void OffscreenWindow::Start() {
  MakeCurrent();
  if (!has_depth_ && RenderFramebuffer->GetFBOIndex() == 0) {
    // VTK would make one with depth, and resizes the one that it finds.
    constexpr int kNumColors = 1;
    constexpr int kDepthBits = 0;
    LastMultiSamples = MultiSamples;
    vtkOpenGLState* const gl = GetState();
    gl->PushFramebufferBindings();
    RenderFramebuffer->PopulateFramebuffer(GetSize()[0], GetSize()[1], /*useTextures=*/true,
                                           kNumColors, VTK_UNSIGNED_CHAR, has_depth_, kDepthBits,
                                           MultiSamples, /*wantStencilAttachment=*/false);
    gl->PopFramebufferBindings();
  }
  Superclass::Start();
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
