// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// A node: a scan that was inserted into submaps. Counted from 0 in the order of insertion.
struct NodeId {
  int index = 0;
};

/// A submap, counted from 0 in the order in which they were begun.
struct SubmapId {
  int index = 0;
};

inline bool operator==(NodeId a, NodeId b) { return a.index == b.index; }
inline bool operator!=(NodeId a, NodeId b) { return a.index != b.index; }
inline bool operator<(NodeId a, NodeId b) { return a.index < b.index; }
inline bool operator==(SubmapId a, SubmapId b) { return a.index == b.index; }
inline bool operator!=(SubmapId a, SubmapId b) { return a.index != b.index; }
inline bool operator<(SubmapId a, SubmapId b) { return a.index < b.index; }

/// As Cartographer prints them, "(trajectory, index)"; a log is one trajectory, 0.
inline std::string ToString(NodeId id) { return "(0, " + std::to_string(id.index) + ")"; }
inline std::string ToString(SubmapId id) { return "(0, " + std::to_string(id.index) + ")"; }

}  // namespace loopscope
