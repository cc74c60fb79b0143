// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <sys/types.h>

namespace loopscope {

/// An X server without a screen to look at, 1280 x 800 pixels, on a display number that it chooses
/// itself. It ends with this object, or with the thread that made it, however that ends.
class XServer {
 public:
  /// Returns when the server answers. Throws std::runtime_error if there is none to start.
  XServer();
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// As in the variable DISPLAY.
  const std::string& display() const { return display_; }

 private:
  pid_t process_ = -1;
  std::string display_;
};

}  // namespace loopscope
