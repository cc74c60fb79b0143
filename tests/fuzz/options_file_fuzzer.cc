// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/io/file_error.h"
#include "core/io/options_file.h"
#include "core/slam/option_values.h"

// Whatever a configuration does: it gives options in their ranges, or is refused, soon.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    loopscope::Options options = loopscope::ParseLuaOptions("fuzz.lua", text).options;
    for (const loopscope::OptionRow& row : loopscope::OptionTable(&options)) {
      loopscope::SetValue(loopscope::GetValue(row), row);
    }
  } catch (const loopscope::FileError&) {
    return 0;
  }
  return 0;
}
