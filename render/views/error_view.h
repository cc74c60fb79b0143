// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/view.h"

namespace loopscope {

/// How wrong a run is at a place of its way.
struct ErrorSample {
  Eigen::Vector2d position;  ///< in the map of the run [m]
  double translation = 0.0;  ///< [m]
  double rotation = 0.0;     ///< [rad], not negative
};

/// What is known of the errors of a run, in the frame of its map.
struct RunErrors {
  std::string run;
  std::string measure;  ///< what the errors are, e.g. "absolute trajectory error"
  std::vector<ErrorSample> samples;
  std::vector<Pose2> way;
  std::vector<Pose2> reference;          ///< empty if there is none
  const Recording* recording = nullptr;  ///< its map is drawn beneath, if there is one
};

/// The samples in the colours of their translations, over the map and the reference, and beside it
/// histograms of translations and rotations. Of `request`, size, theme, title and text count.
Scene BuildErrorView(const RunErrors& errors, const ViewRequest& request, int oversampling = 1);

}  // namespace loopscope
