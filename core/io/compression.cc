// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/compression.h"

#include <algorithm>
#include <cassert>
#include <libdeflate.h>
#include <memory>
#include <zlib.h>

#include "core/io/file_error.h"

namespace loopscope {

std::string Compress(std::string_view bytes) {
  constexpr int kLevel = 9;  // of 12
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  std::string compressed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  const std::size_t size = libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                                    compressed.data(), compressed.size());
  assert(size > 0);
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
