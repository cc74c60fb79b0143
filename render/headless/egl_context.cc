// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "render/headless/gl_context.h"
#include "render/headless/gl_symbols.h"

namespace loopscope {
namespace {

void Require(bool success, const char* call) {
  if (success) return;
  throw std::runtime_error("EGL: no surfaceless OpenGL 3.2 core context (" + std::string(call) +
                           ", error " + std::to_string(eglGetError()) + ")");
}

class EglContext : public GlContext {
 public:
  EglContext() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    Require(display_ != EGL_NO_DISPLAY, "eglGetPlatformDisplay");
    Require(eglInitialize(display_, nullptr, nullptr), "eglInitialize");
    Require(eglBindAPI(EGL_OPENGL_API), "eglBindAPI");
    const EGLConfig config = ChooseConfig();
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size);
    Require(surface_ != EGL_NO_SURFACE, "eglCreatePbufferSurface");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    Require(context_ != EGL_NO_CONTEXT, "eglCreateContext");
  }
  // The display stays initialized: it is shared by all contexts of the process.
  ~EglContext() override {
    if (IsCurrent()) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_, context_);
    eglDestroySurface(display_, surface_);
  }

  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void MakeCurrent() override {
    SetGlLoader(&eglGetProcAddress);
    Require(eglMakeCurrent(display_, surface_, surface_, context_), "eglMakeCurrent");
  }
  bool IsCurrent() const override { return eglGetCurrentContext() == context_; }

 private:
  EGLConfig ChooseConfig() const {
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint num_configs = 0;
    Require(eglChooseConfig(display_, wanted, &config, 1, &num_configs) && num_configs == 1,
            "eglChooseConfig");
    return config;
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> MakeEglContext() { return std::make_unique<EglContext>(); }

}  // namespace loopscope
