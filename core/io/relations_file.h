// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/evaluation/relations.h"

namespace loopscope {

/// Reads relations in Freiburg's text format, "t1 t2 x y z roll pitch yaw" a line; z, roll and
/// pitch are ignored. Throws FileError if the file cannot be read, a line is none, or there is
/// none.
std::vector<Relation> ReadRelations(const std::string& path);

/// Writes one `t1 t2 x y z roll pitch yaw` line a relation, z, roll and pitch 0. Throws FileError.
void WriteRelations(const std::string& path, const std::vector<Relation>& relations);

}  // namespace loopscope
