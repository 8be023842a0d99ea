// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/png.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <string_view>

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr int kZlibLevel = 6;
constexpr std::size_t kBytesPerPixel = 3, kNumFilters = 5;

void append_big_endian(std::uint32_t value, std::string& out) {
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<char>(value >> shift & 0xff));
}

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void append_chunk(std::string_view type, std::string_view data, std::string& out) {
  append_big_endian(static_cast<std::uint32_t>(data.size()), out);
  const std::size_t first = out.size();
  out.append(type).append(data);
  append_big_endian(crc_of(std::string_view(out).substr(first)), out);
}

std::string header(const Image& image) {
  std::string out;
  append_big_endian(static_cast<std::uint32_t>(image.width), out);
  append_big_endian(static_cast<std::uint32_t>(image.height), out);
  // 8 bits a channel, RGB, and the only methods that the specification has; not interlaced.
  for (const char byte : {8, 2, 0, 0, 0}) out.push_back(byte);
  return out;
}

using Row = std::vector<std::uint8_t>;

Row row_bytes(const Image& image, std::size_t y) {
  Row out;
  out.reserve(image.width * kBytesPerPixel);
  for (std::size_t x = 0; x < image.width; ++x) {
    const Colour& c = image.at(x, y);
    out.insert(out.end(), {c.red, c.green, c.blue});
  }
  return out;
}

// Whichever of left, above and corner is nearest to left + above - corner, in this order on ties.
int paeth(int left, int above, int corner) {
  const int from_left = std::abs(above - corner), from_above = std::abs(left - corner),
            from_corner = std::abs(left + above - 2 * corner);
  if (from_left <= from_above && from_left <= from_corner) return left;
  return from_above <= from_corner ? above : corner;
}

int predicted(std::size_t filter, int left, int above, int corner) {
  switch (filter) {
    case 0: return 0;
    case 1: return left;
    case 2: return above;
    case 3: return (left + above) / 2;
    default: return paeth(left, above, corner);
  }
}

// The number of the filter, then the differences from what it predicts.
std::string filtered(std::size_t filter, const Row& above, const Row& row) {
  std::string out(1, static_cast<char>(filter));
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_first = i < kBytesPerPixel;
    const int left = is_first ? 0 : row[i - kBytesPerPixel],
              corner = is_first ? 0 : above[i - kBytesPerPixel];
    out.push_back(static_cast<char>(row[i] - predicted(filter, left, above[i], corner)));
  }
  return out;
}

std::uint64_t sum_of_magnitudes(std::string_view differences) {
  std::uint64_t sum = 0;
  for (const char d : differences)
    sum += static_cast<std::uint64_t>(std::abs(static_cast<signed char>(d)));
  return sum;
}

// The filter whose differences have the least sum of magnitudes, the first of several: the heuristic that the
// specification recommends (section 12.8).
std::string best_filtered(const Row& above, const Row& row) {
  std::string best;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (std::size_t filter = 0; filter < kNumFilters; ++filter) {
    std::string candidate = filtered(filter, above, row);
    const std::uint64_t sum = sum_of_magnitudes(std::string_view(candidate).substr(1));
    if (sum < least) least = sum, best.swap(candidate);
  }
  return best;
}

std::string filtered_rows(const Image& image) {
  std::string out;
  out.reserve(image.height * (1 + image.width * kBytesPerPixel));
  Row above(image.width * kBytesPerPixel, 0);
  for (std::size_t y = 0; y < image.height; ++y) {
    Row row = row_bytes(image, y);
    out += best_filtered(above, row);
    above.swap(row);
  }
  return out;
}

std::string compressed(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string out(size, '\0');
  const int status =
      ::compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kZlibLevel);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  VT_CHECK(status == Z_OK, "compressBound reserves enough");
  out.resize(size);
  return out;
}

// A chunk may have 2^31 - 1 bytes; larger data are cut into several chunks.
void append_data(std::string_view data, std::string& out) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  for (; data.size() > kMost; data.remove_prefix(kMost))
    append_chunk("IDAT", data.substr(0, kMost), out);
  append_chunk("IDAT", data, out);
}

}  // namespace

std::string png_bytes(const Image& image) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  VT_CHECK(0 < image.width && image.width <= kMost && 0 < image.height && image.height <= kMost,
           "a PNG has 1 to 2^31 - 1 rows and columns");
  VT_CHECK(image.pixels.size() == image.width * image.height, "one colour a pixel");
  std::string out = "\x89PNG\r\n\x1a\n";
  append_chunk("IHDR", header(image), out);
  append_chunk("sRGB", std::string(1, '\0'), out);  // rendering intent: perceptual
  append_data(compressed(filtered_rows(image)), out);
  append_chunk("IEND", "", out);
  return out;
}

}  // namespace veritope
