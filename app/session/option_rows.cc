// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/option_rows.h"

#include "core/slam/option_values.h"

namespace loopscope {
namespace {

OptionEntry::Kind KindOf(const OptionRow& row) {
  if (std::holds_alternative<bool*>(row.field)) return OptionEntry::Kind::kFlag;
  return std::holds_alternative<int*>(row.field) ? OptionEntry::Kind::kWholeNumber
                                                 : OptionEntry::Kind::kNumber;
}

}  // namespace

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
                       KindOf(row), row.minimum, row.maximum, row.unit, ExpectedValue(row),
                       row.sentence});
  }
  return entries;
}

Options WithEdits(const Options& options, const std::vector<OptionEdit>& edits) {
  Options edited = options;
  for (const OptionEdit& edit : edits) SetFromAssignment(edit.key + "=" + edit.text, &edited);
  return edited;
}

std::optional<std::string> ErrorOf(const OptionEdit& edit) {
  try {
    WithEdits(Options(), {edit});
    return std::nullopt;
  } catch (const OptionError& error) {
    return error.what();
  }
}

std::vector<std::string> AssignmentsOf(const Options& options, const Options& preset) {
  std::vector<std::string> assignments;
  for (const OptionEntry& entry : OptionRows(options, preset)) {
    if (entry.changed) assignments.push_back(entry.key + "=" + entry.value);
  }
  return assignments;
}

}  // namespace loopscope
