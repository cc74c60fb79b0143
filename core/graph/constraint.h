// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"

namespace loopscope {

/// A term of eq. 4: node j was seen at this pose in the frame of submap i.
struct Constraint {
  enum class Tag {
    kIntraSubmap,  ///< j was inserted into i
    kInterSubmap,  ///< j was found in i by a loop search
  };

  SubmapId submap;
  NodeId node;
  Pose2 submap_from_node;           ///< xi_ij
  double translation_weight = 0.0;  ///< [1/m], square root of the information
  double rotation_weight = 0.0;     ///< [1/rad]
  Tag tag = Tag::kIntraSubmap;
};

}  // namespace loopscope
