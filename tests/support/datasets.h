// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>

namespace loopscope {

/// Where the public data sets are, if they are there. The target must define
/// LOOPSCOPE_SOURCE_DIR.
inline std::filesystem::path DatasetsFolder() {
  const char* const folder = std::getenv("LOOPSCOPE_DATASETS");
  return folder != nullptr ? folder : LOOPSCOPE_SOURCE_DIR "/../shared/data";
}

}  // namespace loopscope
