// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/io/byte_stream.h"
#include "core/slam/recording.h"

namespace loopscope {

/// Packs the poses of one step after the other, so that each comes back bit for bit. Those that are
/// Rounded, as a mapper makes them, take two or three bytes a number: their differences from each
/// other are stored, that of the prior from where the last two poses lead.
class StepPoseCodec {
 public:
  void Put(const Step& step, ByteWriter* out);

  /// Sets the poses of `step`. Fails as ByteReader does.
  void Get(ByteReader* in, Step* step);

 private:
  Pose2 Prediction() const;
  void Remember(const Pose2& pose);

  Pose2 last_;
  Pose2 before_last_;
};

}  // namespace loopscope
