// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

namespace loopscope {

/// Runs a statement once with these values for its parameters.
template <typename... Values>
void Run(SQLite::Statement& statement, const Values&... values) {
  SQLite::bind(statement, values...);
  statement.exec();
  statement.reset();
  statement.clearBindings();
}

/// Likewise, with a BLOB as the last parameter.
template <typename... Values>
void RunWithBlob(SQLite::Statement& statement, const std::string& blob, const Values&... values) {
  SQLite::bind(statement, values...);
  statement.bind(sizeof...(values) + 1, blob.data(), static_cast<int>(blob.size()));
  statement.exec();
  statement.reset();
}

}  // namespace loopscope
