// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/relations_file.h"

#include <iterator>

#include <fmt/format.h>

#include "core/io/number_rows.h"
#include "core/io/replace_file.h"

namespace loopscope {

std::vector<Relation> ReadRelations(const std::string& path) {
  std::vector<Relation> relations;
  for (const NumberRow& row : ReadNumberRows(path, "t1 t2 x y z roll pitch yaw")) {
    relations.push_back({row[0], row[1], Pose2(row[2], row[3], NormalizeAngle(row[7]))});
  }
  return relations;
}

void WriteRelations(const std::string& path, const std::vector<Relation>& relations) {
  std::string text;
  for (const auto& [first_time, second_time, pose] : relations) {
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.6f} {:.6f} {:.6f} 0 0 0 {:.6f}\n",
                   first_time, second_time, pose.x(), pose.y(), pose.rotation);
  }
  ReplaceFile(path, text);
}

}  // namespace loopscope
