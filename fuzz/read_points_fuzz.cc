// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_points_fuzz.cc: any bytes as lines of points, as rows, and as the header of an .npy file. Rows of three
// numbers are exact points. Whatever coordinates the reader accepts, the C++ checker must accept as coordinates of an
// answers file, and mean the same number by them: otherwise answers would be written that no certificate can speak
// about.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/points/npy_header.h"
#include "io/points/read_point.h"
#include "io/points/read_row.h"
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

template <typename Visit>
void for_each_line(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string padded = std::string(text.substr(0, end)) + std::string(16, '\n');
    visit(std::string_view(padded).substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void read_lines(std::string_view text, Decimals decimals, std::size_t dimension) {
  PointLines lines(decimals, {}, dimension);
  for_each_line(text, [&](std::string_view line) {
    std::optional<PointFault> fault;
    const auto point = lines.read(line, fault);
    VT_CHECK(!point || !fault, "a point with a fault");
    VT_CHECK(!fault || (fault->column >= 1 && fault->column <= line.size() + 1),
             "a column off the line");
    if (!point) return;
    for (std::size_t k = 0; k < dimension; ++k) {
      const auto* p = std::get_if<Vec3d>(&point->point);
      const Rational value = p != nullptr ? Rational::from_double((*p)[static_cast<int>(k)])
                                          : std::get<ExactPoint>(point->point)[k];
      expect_same(point->tokens[k], value, decimals == Decimals::kNearest);
    }
  });
}

void read_rows(std::string_view text) {
  RowLines rows(1, 40, {});
  std::size_t columns = 0;
  for_each_line(text, [&](std::string_view line) {
    std::optional<PointFault> fault;
    const auto row = rows.read(line, fault);
    VT_CHECK(!row || !fault, "a row with a fault");
    VT_CHECK(!fault || (fault->column >= 1 && fault->column <= line.size() + 1),
             "a column off the line");
    if (!row) return;
    VT_CHECK(!row->empty() && row->size() <= 40, "the number of columns");
    VT_CHECK(columns == 0 || row->size() == columns, "rows of one length");
    columns = row->size();
  });
}

void compare_with_points(std::string_view text) {
  PointLines lines(Decimals::kExact, {}, 3);
  RowLines rows(3, 3, {});
  for_each_line(text, [&](std::string_view line) {
    std::optional<PointFault> point_fault, row_fault;
    const auto point = lines.read(line, point_fault);
    const auto row = rows.read(line, row_fault);
    VT_CHECK(
        point_fault.has_value() == row_fault.has_value() && point.has_value() == row.has_value(),
        "a row of three numbers is a point");
    for (std::size_t k = 0; row && k < 3; ++k) {
      const auto* p = std::get_if<Vec3d>(&point->point);
      VT_CHECK((*row)[k] == (p != nullptr ? Rational::from_double((*p)[static_cast<int>(k)])
                                          : std::get<ExactPoint>(point->point)[k]),
               "the row has another number");
    }
  });
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
  read_rows(text);
  compare_with_points(text);
  return 0;
}
