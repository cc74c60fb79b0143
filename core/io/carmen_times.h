// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/io/carmen_line.h"
#include "core/io/log_notes.h"

namespace loopscope {

/// One time [s] for each record: that of the message, or where it has none, that of the logger
/// moved to the clock of the messages. If the messages' clock stands still (e.g. was printed with
/// six digits) and the logger's does not, the logger's it is. Records that have neither, in a log
/// that has times, are removed. Stamps that run backwards or stand still are told, not changed.
std::vector<double> ResolveTimes(std::vector<CarmenRecord>* records, LogNotes* notes);

}  // namespace loopscope
