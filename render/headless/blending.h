// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/palette.h"

namespace loopscope {

/// A row of pixels over an opaque one, `ground`. Those of `over` are as OpenGL leaves them on what
/// was clear and black: their colours are multiplied by their opacity.
void BlendRow(const Color* over, const Color* ground, std::size_t num_pixels, Color* blended);

}  // namespace loopscope
