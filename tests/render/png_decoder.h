// SPDX-License-Identifier: LGPL-3.0-or-later
// A reader of PNG files of 8-bit RGB, written from the specification: it shares zlib's inflate with the writer, and
// nothing else.
#pragma once
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"

namespace veritope::picture_test {

struct PngChunk {
  std::string type, data;
};

inline std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// CRC-32 of ISO 3309, bit by bit.
inline std::uint32_t slow_crc(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
  return ~crc;
}

/// Nothing unless signature, lengths and check sums are right.
inline std::optional<std::vector<PngChunk>> png_chunks(std::string_view bytes) {
  if (bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n") return {};
  std::vector<PngChunk> out;
  for (std::size_t at = 8; at < bytes.size();) {
    if (at + 12 > bytes.size()) return {};
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - 12) return {};
    if (slow_crc(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length)) return {};
    out.push_back(
        {std::string(bytes.substr(at + 4, 4)), std::string(bytes.substr(at + 8, length))});
    at += length + 12;
  }
  return out;
}

/// Undoes the filter of a row whose bytes are `row`, after the row `above`.
inline bool unfilter(int filter, const std::vector<int>& above, std::vector<int>& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int a = i < 3 ? 0 : row[i - 3], b = above[i], c = i < 3 ? 0 : above[i - 3];
    const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
    const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    const int predictions[] = {0, a, b, (a + b) / 2, paeth};
    if (filter < 0 || filter > 4) return false;
    row[i] = (row[i] + predictions[filter]) & 255;
  }
  return true;
}

inline std::optional<std::string> inflated(std::string_view data, std::size_t size) {
  std::string out(size + 1, '\0');
  uLongf length = out.size();
  const int status = uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                                reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (status != Z_OK || length != size) return {};
  out.resize(size);
  return out;
}

inline std::optional<Image> decoded_png(std::string_view bytes) {
  const auto chunks = png_chunks(bytes);
  if (!chunks || chunks->size() < 3 || chunks->front().type != "IHDR" ||
      chunks->back().type != "IEND")
    return {};
  const std::string& header = chunks->front().data;
  if (header.size() != 13 || header.substr(8) != std::string("\x08\x02\0\0\0", 5)) return {};
  Image image(big_endian(header, 0), big_endian(header, 4), Colour{});
  std::string data;
  for (const PngChunk& chunk : *chunks)
    if (chunk.type == "IDAT") data += chunk.data;
  const std::size_t stride = 1 + 3 * image.width;
  const auto rows = inflated(data, stride * image.height);
  if (!rows) return {};
  std::vector<int> above(stride - 1, 0), row(stride - 1);
  for (std::size_t y = 0; y < image.height; ++y, above = row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<unsigned char>((*rows)[y * stride + 1 + i]);
    if (!unfilter((*rows)[y * stride], above, row)) return {};
    for (std::size_t x = 0; x < image.width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(row[3 * x]),
                        static_cast<std::uint8_t>(row[3 * x + 1]),
                        static_cast<std::uint8_t>(row[3 * x + 2])};
  }
  return image;
}

}  // namespace veritope::picture_test
