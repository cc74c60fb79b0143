// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/compression.h"

#include <algorithm>
#include <cassert>
#include <zlib.h>

#include "core/io/file_error.h"

namespace loopscope {

std::string Compress(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string compressed(size, '\0');
  [[maybe_unused]] const int result =
      compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  assert(result == Z_OK);
  compressed.resize(size);
  return compressed;
}

std::string Decompress(std::string_view compressed, std::size_t max_size, const std::string& file,
                       const std::string& where) {
  // Grown as needed: neither the stream nor its reader knows the size.
  std::string bytes(std::min(4 * compressed.size() + 64, max_size), '\0');
  z_stream stream{};
  inflateInit(&stream);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
  stream.avail_in = static_cast<uInt>(compressed.size());
  int result = Z_OK;
  while (true) {
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data()) + stream.total_out;
    stream.avail_out = static_cast<uInt>(bytes.size() - stream.total_out);
    result = inflate(&stream, Z_NO_FLUSH);
    if (result != Z_OK || stream.avail_out > 0 || bytes.size() == max_size) break;
    bytes.resize(std::min(2 * bytes.size(), max_size));
  }
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  if (result != Z_STREAM_END)
    throw FileError(file, "damaged data, " + where + ": not a zlib stream");
  return bytes;
}

}  // namespace loopscope
