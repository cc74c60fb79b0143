// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/option_rows.h"

#include "core/slam/option_values.h"

namespace loopscope {

std::vector<OptionEntry> OptionRows(const Options& options, const Options& preset) {
  Options options_copy = options;
  Options preset_copy = preset;
  const std::vector<OptionRow> table = OptionTable(&options_copy);
  const std::vector<OptionRow> preset_table = OptionTable(&preset_copy);
  std::vector<OptionEntry> entries;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const OptionRow& row = table[i];
    const OptionValue value = GetValue(row);
    const OptionValue preset_value = GetValue(preset_table[i]);
    entries.push_back({row.key, ToText(value), ToText(preset_value), value != preset_value,
                       row.unit, ExpectedValue(row), row.sentence});
  }
  return entries;
}

}  // namespace loopscope
