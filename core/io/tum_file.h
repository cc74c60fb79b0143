// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/geometry/trajectory.h"

namespace loopscope {

/// Reads a trajectory in the text format of TUM's RGB-D benchmark, "time x y z qx qy qz qw" a line;
/// z and all of the rotation but its yaw are ignored. The result is in the order of time.
/// Throws FileError if the file cannot be read, a line is no pose, or there is none.
Trajectory ReadTum(const std::string& path);

/// Writes `trajectory`, in its order, replacing the file. Throws FileError if that cannot be done.
void WriteTum(const std::string& path, const Trajectory& trajectory);

}  // namespace loopscope
