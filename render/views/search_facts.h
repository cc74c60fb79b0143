// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/slam/derive.h"
#include "render/annotation.h"
#include "render/layers/search_part.h"

namespace loopscope {

/// The numbers of a search: what came of it, or if the filter asks for some of the visits, how far
/// it had come by then.
std::vector<Fact> FactsOf(const SearchReplay& search, const SearchPart& part);

}  // namespace loopscope
