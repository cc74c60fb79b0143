// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_times.h"

#include <algorithm>
#include <optional>
#include <string>

namespace loopscope {
namespace {

using Records = std::vector<CarmenRecord>;

/// How often the stamp changes from one scan to the next.
int NumChanges(const Records& records, double CarmenStamps::*clock) {
  int num_changes = 0;
  std::optional<double> last;
  for (const CarmenRecord& record : records) {
    if (!record.scan) continue;
    const double stamp = record.stamps.*clock;
    num_changes += last && stamp != *last;
    last = stamp;
  }
  return num_changes;
}

bool HasTime(const CarmenRecord& record) {
  return record.stamps.ipc != 0.0 || record.stamps.logger != 0.0;
}

/// Zero is a time if the log begins with it and goes on from there.
void RemoveRecordsWithoutTime(Records* records, LogNotes* notes) {
  constexpr double kLongestLog = 1e6;  // times above are dates [s]
  const auto first_timed = std::find_if(records->begin(), records->end(), HasTime);
  if (first_timed == records->end()) return;
  const double first_time = std::max(first_timed->stamps.ipc, first_timed->stamps.logger);
  const auto begin = first_time < kLongestLog ? first_timed : records->begin();
  for (auto record = begin; record != records->end(); ++record) {
    if (!HasTime(*record)) notes->Add("lines whose time is zero, skipped", record->line);
  }
  records->erase(std::remove_if(begin, records->end(),
                                [](const CarmenRecord& record) { return !HasTime(record); }),
                 records->end());
}

/// What to add to the logger's clock to get the messages'.
double IpcMinusLogger(const Records& records) {
  for (const CarmenRecord& record : records) {
    if (record.stamps.ipc != 0.0 && record.stamps.logger != 0.0) {
      return record.stamps.ipc - record.stamps.logger;
    }
  }
  return 0.0;
}

/// Tells of the order of the times of the records that `select` picks.
template <typename Select>
void NoteOrder(const Records& records, const std::vector<double>& times, const std::string& name,
               LogNotes* notes, const Select& select) {
  std::optional<double> last;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!select(records[i])) continue;
    if (last && times[i] < *last) {
      notes->Add(name + " stamps that run backwards", records[i].line);
    } else if (last && times[i] == *last) {
      notes->Add(name + " stamps that stand still", records[i].line);
    }
    last = times[i];
  }
}

}  // namespace

std::vector<double> ResolveTimes(std::vector<CarmenRecord>* records, LogNotes* notes) {
  RemoveRecordsWithoutTime(records, notes);
  const bool use_logger =
      2 * NumChanges(*records, &CarmenStamps::ipc) < NumChanges(*records, &CarmenStamps::logger);
  const double ipc_minus_logger = IpcMinusLogger(*records);
  std::vector<double> times;
  times.reserve(records->size());
  for (const CarmenRecord& record : *records) {
    const CarmenStamps& stamps = record.stamps;
    const bool missing = stamps.ipc == 0.0 && stamps.logger != 0.0;
    if (use_logger || missing) notes->Add("stamps taken from the logger's clock", record.line);
    if (use_logger) {
      times.push_back(stamps.logger);
    } else {
      times.push_back(missing ? stamps.logger + ipc_minus_logger : stamps.ipc);
    }
  }
  NoteOrder(*records, times, "scan", notes,
            [](const CarmenRecord& record) { return record.scan.has_value(); });
  NoteOrder(*records, times, "odometry", notes,
            [](const CarmenRecord& record) { return !record.scan && record.odom_from_base; });
  return times;
}

}  // namespace loopscope
