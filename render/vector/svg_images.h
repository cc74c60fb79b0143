// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// Completes what cairo wrote about images. They are named image0, image1, ... in the order in
/// which they come: cairo counts them over the whole process, so that its second picture would have
/// other bytes. Those whose pixels are larger than a unit keep the edges of their cells sharp.
std::string WithFinishedImages(const std::string& svg);

}  // namespace loopscope
