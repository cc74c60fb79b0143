// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/scene.h"

namespace loopscope {

enum class VectorFormat { kSvg, kPdf };

/// `scene` as an SVG or PDF document, as large as the picture: a pixel of an SVG or
/// a point of a PDF for each of its pixels. Lines,
/// marks and texts stay sharp at any size; grids are images in it, and so is a layer of so many
/// marks that they would make the file huge. It needs no OpenGL. The same scene gives the same
/// bytes. Throws std::runtime_error if cairo fails.
std::string EncodeVectorPicture(const Scene& scene, VectorFormat format);

}  // namespace loopscope
