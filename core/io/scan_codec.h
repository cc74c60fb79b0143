// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/io/byte_stream.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

/// Packs scans so that each float comes back bit for bit. Ranges that are whole multiples of 1 cm,
/// 1 mm or 0.1 mm, as real scanners give them, are stored as differences from beam to beam.
void PutScans(const std::vector<LaserScan>& scans, ByteWriter* out);

/// The scans that PutScans packed. Fails as ByteReader does.
std::vector<LaserScan> GetScans(ByteReader* in);

void PutOdometry(const std::vector<OdometryReading>& odometry, ByteWriter* out);
std::vector<OdometryReading> GetOdometry(ByteReader* in);

}  // namespace loopscope
