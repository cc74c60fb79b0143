// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/pose2.h"
#include "core/io/byte_stream.h"

namespace loopscope {

/// Packs `values` so that each comes back bit for bit. If nearly all are whole multiples of 10^-d
/// or 2^-k, as are numbers that once were text or were rounded, the differences of the multiples
/// are stored; else the bits. value[i] is expected near to predictions[i], as far as there are any,
/// and else near to value[i - 1].
void PutDoubles(const std::vector<double>& values, const std::vector<double>& predictions,
                ByteWriter* out);

/// The values that PutDoubles packed with the same predictions. Fails as ByteReader does.
std::vector<double> GetDoubles(const std::vector<double>& predictions, ByteReader* in);

/// Likewise for poses.
void PutPoses(const std::vector<Pose2>& poses, const std::vector<Pose2>& predictions,
              ByteWriter* out);
std::vector<Pose2> GetPoses(const std::vector<Pose2>& predictions, ByteReader* in);

}  // namespace loopscope
