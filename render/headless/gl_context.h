// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace loopscope {

/// Who draws when there is no window.
enum class Backend {
  kAuto,    ///< kOsmesa, and kEgl where that fails
  kOsmesa,  ///< Mesa's software renderer into plain memory: needs no device and no display
  kEgl,     ///< EGL on Mesa's surfaceless platform: needs no display, may use a device
};

/// "auto", "osmesa" or "egl". Throws std::invalid_argument naming these for anything else.
Backend BackendFromName(const std::string& name);

/// An OpenGL 3.2 core context without a window. It belongs to one thread at a time.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// Throws std::runtime_error if the driver refuses.
  virtual void MakeCurrent() = 0;
  virtual bool IsCurrent() const = 0;
};

/// Throws std::runtime_error saying which back end failed, and where.
std::unique_ptr<GlContext> MakeGlContext(Backend backend);

std::unique_ptr<GlContext> MakeOsmesaContext();
std::unique_ptr<GlContext> MakeEglContext();

}  // namespace loopscope
