// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/log_stem.h"

namespace loopscope {
namespace {

std::string WithoutEnd(const std::string& text, const std::string& end) {
  if (text.size() < end.size() || text.substr(text.size() - end.size()) != end) return text;
  return text.substr(0, text.size() - end.size());
}

}  // namespace

std::string LogStem(const std::string& log_path) {
  return WithoutEnd(WithoutEnd(WithoutEnd(log_path, ".gz"), ".log"), ".clf");
}

}  // namespace loopscope
