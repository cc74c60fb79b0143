// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace loopscope {

/// PRAGMA application_id of a recording: "Loop" in ASCII.
constexpr int kRecordingApplicationId = 0x4c6f6f70;

/// PRAGMA user_version. A reader takes all versions up to its own.
/// 2: table optimization has drift shares. 3: the poses of a step are packed, and it says where its
/// match began. 4: that may be by scans ahead. 5: or by motions before. 6: and whether walls
/// were wider.
constexpr int kRecordingSchemaVersion = 6;

/// The statements that make the tables of an empty recording, with their documentation, which
/// SQLite keeps: `sqlite3 run.loopscope .schema` shows it.
extern const char kRecordingSchema[];

constexpr std::size_t kScansPerChunk = 100;
constexpr std::size_t kOdometryPerChunk = 1000;

/// Largest chunk of a table, unpacked [bytes].
constexpr std::size_t kMaxChunkSize = std::size_t{1} << 28;

}  // namespace loopscope
