// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace loopscope {

/// Makes `content` the content of the file at `path`, all at once: it is written to a file beside
/// it that is then renamed, so that a failure leaves what was there. Devices and pipes are written
/// to directly. Throws FileError if the content cannot be written.
void ReplaceFile(const std::string& path, std::string_view content);

}  // namespace loopscope
