// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <stdexcept>

#include <GL/osmesa.h>

#include "render/headless/gl_context.h"
#include "render/headless/gl_symbols.h"

namespace loopscope {
namespace {

class OsmesaContext : public GlContext {
 public:
  OsmesaContext() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              2,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (context_ == nullptr) {
      throw std::runtime_error("OSMesa: no OpenGL 3.2 core context (OSMesaCreateContextAttribs)");
    }
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void MakeCurrent() override {
    SetGlLoader(&OSMesaGetProcAddress);
    if (!OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      throw std::runtime_error("OSMesa: the context cannot be used (OSMesaMakeCurrent)");
    }
  }
  bool IsCurrent() const override { return OSMesaGetCurrentContext() == context_; }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> pixel_{};  // VTK draws into framebuffers of its own, never here
};

}  // namespace

std::unique_ptr<GlContext> MakeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace loopscope
