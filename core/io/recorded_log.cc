// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recorded_log.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/io/byte_stream.h"
#include "core/io/compression.h"
#include "core/io/file_error.h"
#include "core/io/recording_check.h"
#include "core/io/recording_schema.h"
#include "core/io/scan_codec.h"
#include "core/io/sqlite_run.h"
#include "core/io/sqlite_table.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

/// Calls insert(first, packed) for every `per_chunk` of `items`.
template <typename Item, typename Put, typename Insert>
void ForEachChunk(const std::vector<Item>& items, std::size_t per_chunk, const Put& put,
                  const Insert& insert) {
  for (std::size_t first = 0; first < items.size(); first += per_chunk) {
    const std::size_t end = std::min(items.size(), first + per_chunk);
    ByteWriter bytes;
    put(std::vector<Item>(items.begin() + first, items.begin() + end), &bytes);
    insert(static_cast<int>(first), Compress(bytes.bytes()));
  }
}

void WriteNotes(const std::vector<LogNote>& notes, SQLite::Database& database) {
  SQLite::Statement insert(database, "INSERT INTO log_note VALUES (NULL, ?, ?, ?)");
  for (const LogNote& note : notes) Run(insert, note.what, note.count, note.first_line);
}

void WriteBeams(const std::vector<BeamGeometry>& beam_geometries, SQLite::Database& database) {
  SQLite::Statement insert(database, "INSERT INTO beam_geometry VALUES (?, ?, ?, ?)");
  int id = 0;
  for (const BeamGeometry& beams : beam_geometries) {
    Run(insert, id++, beams.num_beams, beams.first_angle, beams.angle_increment);
  }
}

/// Calls take(&reader) for every row of a table of chunks, whose first column says how many items
/// stand before it; take returns how many there are in all.
template <typename Take>
void ReadChunks(const std::string& path, SQLite::Database& database, const std::string& name,
                const Take& take) {
  SqliteTable table(database, path, name, "SELECT * FROM " + name + " ORDER BY 1");
  std::size_t num_items = 0;
  while (table.Next()) {
    const std::string where = fmt::format("{} {}", name, table.Int(0));
    const std::string bytes = table.Unpacked(1, kMaxChunkSize, where);
    ByteReader in(bytes, path, where);
    if (static_cast<std::size_t>(table.Int(0)) != num_items) in.Fail("some before are missing");
    num_items = take(&in);
    in.ExpectEnd();
  }
}

std::vector<LaserScan> ReadScans(const std::string& path, SQLite::Database& database) {
  constexpr std::size_t kMaxReadings = 200'000'000;
  std::size_t num_readings = 0;
  std::vector<LaserScan> scans;
  ReadChunks(path, database, "scan_chunk", [&](ByteReader* in) {
    for (LaserScan& scan : GetScans(in)) {
      num_readings += scan.ranges.size();
      if (num_readings > kMaxReadings) in->Fail("there are too many readings");
      scans.push_back(std::move(scan));
    }
    return scans.size();
  });
  return scans;
}

std::vector<OdometryReading> ReadOdometry(const std::string& path, SQLite::Database& database) {
  std::vector<OdometryReading> odometry;
  ReadChunks(path, database, "odometry_chunk", [&](ByteReader* in) {
    const std::vector<OdometryReading> readings = GetOdometry(in);
    odometry.insert(odometry.end(), readings.begin(), readings.end());
    return odometry.size();
  });
  return odometry;
}

}  // namespace

void WriteRecordedLog(const ScanLog& log, SQLite::Database& database) {
  SQLite::Statement insert(database, "INSERT INTO log VALUES (?, ?, ?, ?, ?, ?)");
  Run(insert, log.name, static_cast<int>(log.scans.size()), static_cast<int>(log.odometry.size()),
      log.base_from_laser.x(), log.base_from_laser.y(), log.base_from_laser.rotation);
  WriteNotes(log.notes, database);
  WriteBeams(log.beam_geometries, database);
  SQLite::Statement insert_scans(database, "INSERT INTO scan_chunk VALUES (?, ?)");
  ForEachChunk(log.scans, kScansPerChunk, PutScans,
               [&](int first, const std::string& blob) { RunWithBlob(insert_scans, blob, first); });
  SQLite::Statement insert_odometry(database, "INSERT INTO odometry_chunk VALUES (?, ?)");
  ForEachChunk(
      log.odometry, kOdometryPerChunk, PutOdometry,
      [&](int first, const std::string& blob) { RunWithBlob(insert_odometry, blob, first); });
}

void WriteRecordedOptions(const Options& options, SQLite::Database& database) {
  constexpr std::string_view kBetween = " = ";
  SQLite::Statement insert(database, "INSERT INTO option VALUES (?, ?)");
  std::istringstream lines(OptionsToText(options));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t between = line.find(kBetween);
    Run(insert, line.substr(0, between), line.substr(between + kBetween.size()));
  }
}

ScanLog ReadRecordedLog(const std::string& path, SQLite::Database& database) {
  ScanLog log;
  SqliteTable table(database, path, "log", "SELECT * FROM log");
  if (!table.Next()) throw FileError(path, "damaged data: the log is missing");
  log.name = table.Text(0);
  log.base_from_laser = table.PoseFrom(3);
  SqliteTable notes(database, path, "log_note",
                    "SELECT what, count, first_line FROM log_note ORDER BY id");
  while (notes.Next()) log.notes.push_back({notes.Text(0), notes.Int(1), notes.Int(2)});
  SqliteTable beams(database, path, "beam_geometry", "SELECT * FROM beam_geometry ORDER BY id");
  while (beams.Next()) {
    log.beam_geometries.push_back({beams.Int(1), beams.Double(2), beams.Double(3)});
  }
  log.scans = ReadScans(path, database);
  log.odometry = ReadOdometry(path, database);
  if (static_cast<int>(log.scans.size()) != table.Int(1) ||
      static_cast<int>(log.odometry.size()) != table.Int(2)) {
    throw FileError(path, "damaged data: scans or odometry are missing");
  }
  if (const auto fault = FaultOf(log)) throw FileError(path, "damaged data: " + *fault);
  return log;
}

Options ReadRecordedOptions(const std::string& path, SQLite::Database& database) {
  std::string text;
  // The calibration of odometry was that of its direction alone until schema 3.
  SqliteTable table(database, path, "option",
                    "SELECT replace(key, 'odometry_direction_', 'odometry_calibration_'), value "
                    "FROM option");
  while (table.Next()) text += table.Text(0) + " = " + table.Text(1) + "\n";
  try {
    return ParseOptions(text, Options());
  } catch (const OptionError& error) {
    throw FileError(path, std::string("damaged data: an option: ") + error.what());
  }
}

}  // namespace loopscope
