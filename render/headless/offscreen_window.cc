// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/offscreen_window.h"

#include <stdexcept>
#include <utility>
#include <vtkObjectFactory.h>

namespace loopscope {

vtkStandardNewMacro(OffscreenWindow);

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

bool OffscreenWindow::IsCurrent() { return context_ && context_->IsCurrent(); }

}  // namespace loopscope
