// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/io/carmen_line.h"
#include "core/io/log_notes.h"

namespace loopscope {

/// Whether a reading [m] is one of the values that the drivers of SICK scanners write where nothing
/// came back: 81.83 ... 81.91, 51.0 ... 51.19, 50.0, 32.77, and 8183 ... 8191 in centimetres.
bool IsNoReturnCode(float reading);

/// Turns the readings of all scans into ranges [m] as in LaserScan::ranges, and tells what it
/// found: +infinity for codes, for what is beyond the announced range or above `max_range` [m], and
/// for the largest value of the log if it piles up there; NaN for what is no number or not above
/// zero; and all times 0.01 if the codes (8183 ... 8191) and the median say that the log is in
/// centimetres.
void CleanReadings(double max_range, std::vector<CarmenRecord>* records, LogNotes* notes);

}  // namespace loopscope
