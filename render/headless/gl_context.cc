// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/gl_context.h"

#include <stdexcept>

namespace loopscope {

Backend BackendFromName(const std::string& name) {
  if (name == "auto") return Backend::kAuto;
  if (name == "osmesa") return Backend::kOsmesa;
  if (name == "egl") return Backend::kEgl;
  throw std::invalid_argument("unknown backend '" + name + "': expected auto, osmesa or egl");
}

std::unique_ptr<GlContext> MakeGlContext(Backend backend) {
  if (backend == Backend::kEgl) return MakeEglContext();
  if (backend == Backend::kOsmesa) return MakeOsmesaContext();
  try {
    return MakeOsmesaContext();
  } catch (const std::runtime_error& osmesa) {
    try {
      return MakeEglContext();
    } catch (const std::runtime_error& egl) {
      throw std::runtime_error(std::string(osmesa.what()) + "; " + egl.what());
    }
  }
}

}  // namespace loopscope
