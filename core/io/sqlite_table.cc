// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/sqlite_table.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/io/compression.h"

namespace loopscope {

SqliteTable::SqliteTable(SQLite::Database& database, std::string file, std::string name,
                         const std::string& query)
    : file_(std::move(file)), name_(std::move(name)), statement_(database, query) {}

int SqliteTable::Int(int column) {
  const SQLite::Column value = statement_.getColumn(column);
  const std::int64_t number = value.getInt64();
  if (!value.isInteger() || number < 0 || number > std::numeric_limits<int>::max()) FailAt(column);
  return static_cast<int>(number);
}

double SqliteTable::Double(int column) {
  const SQLite::Column value = statement_.getColumn(column);
  if (!value.isFloat() || !std::isfinite(value.getDouble())) FailAt(column);
  return value.getDouble();
}

Pose2 SqliteTable::PoseFrom(int column) {
  return Pose2(Double(column), Double(column + 1), Double(column + 2));
}

std::string_view SqliteTable::Bytes(int column) {
  const SQLite::Column value = statement_.getColumn(column);
  const auto* const data = static_cast<const char*>(value.getBlob());
  return {data, static_cast<std::size_t>(value.getBytes())};
}

std::string SqliteTable::Unpacked(int column, std::size_t max_size, const std::string& where) {
  return Decompress(Bytes(column), max_size, file_, where);
}

void SqliteTable::FailAt(int column) {
  throw FileError(file_, "damaged data, table " + name_ + ": column " +
                             statement_.getColumnName(column) + " is out of range");
}

}  // namespace loopscope
