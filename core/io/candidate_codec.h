// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/loop_candidate.h"
#include "core/io/byte_stream.h"

namespace loopscope {

/// Packs the candidates applied in one step so that each value comes back bit for bit, column by
/// column. Of a pair that was not searched there is little to store but its ids, and of one that
/// was not accepted no refined pose.
void PutCandidates(const std::vector<LoopCandidate>& candidates, ByteWriter* out);

/// What PutCandidates packed, applied in `step`. Fails as ByteReader does, and if they are more
/// than `max_count`: well packed bytes may hold far more of them than memory.
std::vector<LoopCandidate> GetCandidates(int step, std::size_t max_count, ByteReader* in);

}  // namespace loopscope
