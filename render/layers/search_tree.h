// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "render/layers/search_part.h"
#include "render/layers/shapes.h"
#include "render/palette.h"
#include "render/scene.h"

namespace loopscope {

/// What the search did at one height of the tree.
struct SearchLevel {
  int height = 0;
  int num_scored = 0;
  int num_expanded = 0;
  /// One node for each block, over all angles shown: an expanded one before one that waits for its
  /// fate, this before a pruned one, then the one with the highest bound. Indices into
  /// SearchTrace::nodes.
  std::vector<int> shown;
};

/// Those that the filter asks for, from the root's height down to 0, also if nothing of a level is
/// shown yet.
std::vector<SearchLevel> LevelsOf(const SearchPart& part);

/// Bounds from the first to the last colour.
struct BoundRange {
  double low = 0.0;
  double high = 1.0;

  double PlaceOf(double bound) const { return (bound - low) / (high - low); }
};

/// Of all bounds, and of what a score must beat: a search that comes nowhere near it is not bright.
BoundRange BoundRangeOf(const SearchTrace& trace, double min_score);

/// The poses of the block of `node`, each as a square of the resolution, in the frame of the submap
/// [m].
Extent BlockOf(const SearchNode& node, const SearchWindow& window);
/// Likewise those of the whole window.
Extent WindowExtent(const SearchWindow& window);

/// Of the fill of a pruned block.
constexpr double kPrunedOpacity = 0.4;

/// All blocks of a height that the search ever came to.
Extent ExtentOfHeight(const SearchTrace& trace, int height);

/// The blocks of a level, filled in the colours of their bounds; pruned ones are faded.
vtkSmartPointer<vtkActor> BlocksLayer(const SearchPart& part, const SearchLevel& level,
                                      const BoundRange& range, const Palette& palette);

/// The blocks of a level that were pruned.
std::vector<Extent> PrunedBlocks(const SearchPart& part, const SearchLevel& level);

/// All of the tree by angle: a column for each angle of the window, a row for each height that it
/// has nodes at, the lowest one at the bottom. Each field stands for the node there that says most,
/// drawn as a block. The fields fill [0, `aspect`] x [0, 1]. An angle that the filter asks for is
/// only one of them.
vtkSmartPointer<vtkActor> AnglesLayer(const SearchPart& part, const BoundRange& range,
                                      double aspect, const Palette& palette);

/// The fields that were pruned.
std::vector<Extent> PrunedFields(const SearchPart& part, double aspect);

/// The field of `node` in AnglesLayer.
Extent FieldOf(const SearchNode& node, const SearchTrace& trace, double aspect);

/// The nodes that the fields of AnglesLayer stand for.
std::vector<int> NodesByAngle(const SearchPart& part);

/// The column of an angle in AnglesLayer.
Extent ColumnOf(int angle_index, const SearchTrace& trace, double aspect);

/// Outlines of the blocks of a level that were expanded.
vtkSmartPointer<vtkActor> ExpandedLayer(const SearchPart& part, const SearchLevel& level,
                                        double line_width, const Palette& palette);

}  // namespace loopscope
