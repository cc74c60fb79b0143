// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/geometry/pose2.h"
#include "core/io/file_error.h"

namespace loopscope {

/// The rows of a query, one after the other, with values that are checked as they are taken: what
/// does not fit throws FileError that names the file, the table and the column.
class SqliteTable {
 public:
  /// `query` is a SELECT; `file` and `name` are for messages.
  SqliteTable(SQLite::Database& database, std::string file, std::string name,
              const std::string& query);

  /// To be called before the first row too. False after the last one.
  bool Next() { return statement_.executeStep(); }

  bool IsNull(int column) { return statement_.getColumn(column).isNull(); }
  int Int(int column);         ///< not below 0
  double Double(int column);   ///< finite
  Pose2 PoseFrom(int column);  ///< x, y and rotation from this column on
  std::string Text(int column) { return statement_.getColumn(column).getString(); }

  /// An enumerator in 0 ... last.
  template <typename Enum>
  Enum EnumUpTo(Enum last, int column) {
    const int number = Int(column);
    if (number > static_cast<int>(last)) FailAt(column);
    return static_cast<Enum>(number);
  }

  /// Until the next row.
  std::string_view Bytes(int column);

  /// The content of a zlib stream, of at most `max_size` bytes; `where` is for messages.
  std::string Unpacked(int column, std::size_t max_size, const std::string& where);

 private:
  [[noreturn]] void FailAt(int column);

  std::string file_;
  std::string name_;
  SQLite::Statement statement_;
};

}  // namespace loopscope
