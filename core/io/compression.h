// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace loopscope {

/// `bytes` as a zlib stream.
std::string Compress(std::string_view bytes);

/// What Compress made `compressed` of. Throws FileError about `where` in `file` if it is no such
/// stream, or would grow to more than `max_size` bytes.
std::string Decompress(std::string_view compressed, std::size_t max_size, const std::string& file,
                       const std::string& where);

}  // namespace loopscope
