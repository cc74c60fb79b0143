// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// The files that a picture can be written to.
enum class PictureFormat { kPng, kSvg, kPdf };

/// By the end of the name, in upper or lower case. Throws std::invalid_argument naming png, svg and
/// pdf for anything else.
PictureFormat PictureFormatOf(const std::string& path);

}  // namespace loopscope
