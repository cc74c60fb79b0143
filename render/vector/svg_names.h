// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// `svg` of cairo with its images named image0, image1, ... in the order in which they come: cairo
/// counts them over the whole process, so that its second picture would have other bytes.
std::string WithOwnNames(const std::string& svg);

}  // namespace loopscope
