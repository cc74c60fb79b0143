// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/relations_file.h"

#include "core/io/number_rows.h"

namespace loopscope {

std::vector<Relation> ReadRelations(const std::string& path) {
  std::vector<Relation> relations;
  for (const NumberRow& row : ReadNumberRows(path, "t1 t2 x y z roll pitch yaw")) {
    relations.push_back({row[0], row[1], Pose2(row[2], row[3], NormalizeAngle(row[7]))});
  }
  return relations;
}

}  // namespace loopscope
