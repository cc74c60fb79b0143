// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace loopscope {

/// Which part of a loop search is looked at.
struct SearchFilter {
  std::optional<int> num_visits;   ///< the tree after so many fates were decided; all
  std::optional<int> height;       ///< only blocks of this height
  std::optional<int> angle_index;  ///< only blocks of this angle

  bool empty() const { return !num_visits && !height && !angle_index; }
};

/// Whether the search view has room for how the scan lies on the walls.
inline bool ShowsCloseUp(const SearchFilter& filter) { return !filter.height; }

}  // namespace loopscope
