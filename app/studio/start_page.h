// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/studio/run_line.h"

namespace loopscope {

/// What a window says that shows nothing yet.
class StartPage : public QWidget {
 public:
  explicit StartPage(const RunLine& run, QWidget* parent = nullptr);
};

}  // namespace loopscope
