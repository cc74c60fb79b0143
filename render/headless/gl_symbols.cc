// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/gl_symbols.h"

#include <dlfcn.h>
#include <string_view>

#include <GL/glew.h>

namespace {

loopscope::GlLoader g_loader = nullptr;

}  // namespace

namespace loopscope {

void SetGlLoader(GlLoader loader) { g_loader = loader; }

}  // namespace loopscope

// There is no GLX here. EGL would answer with stubs for its names that crash when called.
extern "C" void (*glXGetProcAddressARB(const unsigned char* name))() {
  const char* const text = reinterpret_cast<const char*>(name);
  if (g_loader == nullptr || std::string_view(text).substr(0, 3) == "glX") return nullptr;
  return g_loader(text);
}

// GLEW looks for GLX last: when it misses that, it has all functions of OpenGL.
extern "C" GLenum GLEWAPIENTRY glewInit() {
  const auto real_init = reinterpret_cast<decltype(&glewInit)>(dlsym(RTLD_NEXT, "glewInit"));
  if (real_init == nullptr) return GLEW_ERROR_NO_GL_VERSION;
  const GLenum error = real_init();
  return error == GLEW_ERROR_GLX_VERSION_11_ONLY ? GLEW_OK : error;
}
