// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/wall_sides.h"
#include "core/slam/derive.h"
#include "render/annotation.h"
#include "render/layers/search_part.h"

namespace loopscope {

/// The numbers of a search: what came of it, or if the filter asks for some of the visits, how far
/// it had come by then.
std::vector<Fact> FactsOf(const SearchReplay& search, const SearchPart& part,
                          const ConstraintBuilderOptions& options);

/// The returns of the scan on walls, where the search has it at last.
ReturnsOnWalls WallsOf(const SearchReplay& search);

}  // namespace loopscope
