// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_points_fuzz.cc: any bytes as lines of points, and as the header of an .npy file. Whatever coordinates the
// reader accepts, the C++ checker must accept as coordinates of an answers file, and mean the same number by them:
// otherwise answers would be written that no certificate can speak about.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/points/npy_header.h"
#include "io/points/read_point.h"
#include "robust/base/check.h"
#include "verify/checker/points/coordinate.h"

namespace {

using namespace veritope;

// numbers.h of the checker: the sign times the other 63 bits; both zeros are 0.
std::int64_t key_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto size = static_cast<std::int64_t>(bits & ~(std::uint64_t{1} << 63));
  return bits >> 63 != 0 ? -size : size;
}

void expect_same(std::string_view token, const Rational& value, bool nearest) {
  const std::string word(token);
  VT_CHECK(::is_coordinate(word, nearest), "the checker refuses a coordinate that is read");
  const ::Coordinate c = ::coordinate(word, nearest);
  VT_CHECK(c.below == key_of(round_down(value)) && c.above == key_of(round_up(value)),
           "the checker reads another number");
}

void read_lines(std::string_view text, Decimals decimals, std::size_t dimension) {
  PointLines lines(decimals, {}, dimension);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string padded = std::string(text.substr(0, end)) + std::string(16, '\n');
    std::optional<PointFault> fault;
    const auto point = lines.read(std::string_view(padded).substr(0, end), fault);
    VT_CHECK(!point || !fault, "a point with a fault");
    VT_CHECK(!fault || (fault->column >= 1 && fault->column <= end + 1), "a column off the line");
    if (point)
      for (std::size_t k = 0; k < dimension; ++k) {
        const auto* p = std::get_if<Vec3d>(&point->point);
        const Rational value = p != nullptr ? Rational::from_double((*p)[static_cast<int>(k)])
                                            : std::get<ExactPoint>(point->point)[k];
        expect_same(point->tokens[k], value, decimals == Decimals::kNearest);
      }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::size_t dimension : {std::size_t{2}, std::size_t{3}}) {
    read_lines(text, Decimals::kNearest, dimension);
    read_lines(text, Decimals::kExact, dimension);
    const auto header = read_npy_header({data, size}, dimension);
    if (header) VT_CHECK(header->num_bytes <= size, "a header beyond its bytes");
  }
  return 0;
}
