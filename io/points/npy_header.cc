// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/npy_header.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace veritope {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

Error refused(std::string why) {
  return {Code::kForeignFormat, {}, "a .npy file, but " + std::move(why)};
}
Error broken(std::string why) { return {Code::kSyntax, {}, "a .npy file, but " + std::move(why)}; }

// A Python dictionary as NumPy writes it: {'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }.
class Dictionary {
 public:
  explicit Dictionary(std::string_view text) : text_(text) {}

  // What follows 'key': up to the comma or brace at its level, without blanks.
  std::optional<std::string> value(std::string_view key) const {
    const std::string quoted = "'" + std::string(key) + "'";
    std::size_t at = text_.find(quoted);
    if (at == text_.npos) return std::nullopt;
    at = text_.find(':', at + quoted.size());
    if (at == text_.npos) return std::nullopt;
    std::string out;
    int depth = 0;
    for (++at; at < text_.size(); ++at) {
      const char c = text_[at];
      if (depth == 0 && (c == ',' || c == '}')) return out;
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (std::isspace(static_cast<unsigned char>(c)) == 0) out += c;
    }
    return std::nullopt;
  }

 private:
  std::string_view text_;
};

// "(2,3)"; nothing if it has not two numbers below 2^62.
std::optional<std::pair<std::uint64_t, std::uint64_t>> pair_of(std::string_view shape) {
  std::uint64_t numbers[2] = {0, 0};
  std::size_t at = 1;
  if (!shape.starts_with('(') || !shape.ends_with(')')) return std::nullopt;
  for (std::uint64_t& n : numbers) {
    const std::size_t begin = at;
    for (; at < shape.size() && std::isdigit(static_cast<unsigned char>(shape[at])) != 0; ++at) {
      if (n >= std::uint64_t{1} << 58) return std::nullopt;
      n = 10 * n + static_cast<std::uint64_t>(shape[at] - '0');
    }
    if (at == begin) return std::nullopt;
    if (&n == numbers && (at == shape.size() || shape[at++] != ',')) return std::nullopt;
  }
  if (shape[at] == ',') ++at;
  if (at + 1 != shape.size()) return std::nullopt;
  return std::pair(numbers[0], numbers[1]);
}

template <typename Bits>
Bits load(const unsigned char* p, bool is_big_endian) {
  Bits out = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i)
    out |= static_cast<Bits>(p[i]) << (8 * (is_big_endian ? sizeof(Bits) - 1 - i : i));
  return out;
}

}  // namespace

bool looks_like_npy(std::span<const unsigned char> bytes) {
  return bytes.size() >= kMagic.size() &&
         std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

Result<NpyHeader> read_npy_header(std::span<const unsigned char> bytes, std::size_t num_columns) {
  if (!looks_like_npy(bytes)) return Error{Code::kSyntax, {}, "this is no .npy file"};
  if (bytes.size() < 12) return broken("it ends in its header");
  const unsigned version = bytes[6];
  if (version < 1 || version > 3) return refused("of version " + std::to_string(version));
  const std::size_t begin = version == 1 ? 10 : 12;
  const std::size_t length =
      version == 1 ? bytes[8] + 256u * bytes[9] : load<std::uint32_t>(bytes.data() + 8, false);
  if (length > kMostNpyHeader - begin) return broken("its header is too long");
  if (length > bytes.size() - begin) return broken("it ends in its header");
  const Dictionary header({reinterpret_cast<const char*>(bytes.data()) + begin, length});
  const auto type = header.value("descr"), order = header.value("fortran_order"),
             shape = header.value("shape");
  if (!type || !order || !shape) return broken("its header lacks descr, fortran_order or shape");
  NpyHeader out;
  out.num_bytes = begin + length;
  if (*type != "'<f8'" && *type != "'<f4'" && *type != "'>f8'" && *type != "'>f4'")
    return refused("with numbers of type " + *type + "; points are float64 or float32");
  out.is_double = type->find('8') != type->npos;
  out.is_big_endian = type->find('>') != type->npos;
  if (*order != "False") return refused("in Fortran order; save a copy in C order");
  const auto size = pair_of(*shape);
  if (!size || size->second != num_columns)
    return refused("with the shape " + *shape + " instead of (n, " + std::to_string(num_columns) +
                   ")");
  out.num_columns = num_columns;
  out.num_points = size->first;
  return out;
}

Vec3d npy_row(const NpyHeader& header, const unsigned char* row) {
  const auto number = [&](std::size_t k) {
    if (header.is_double)
      return std::bit_cast<double>(load<std::uint64_t>(row + 8 * k, header.is_big_endian));
    return static_cast<double>(
        std::bit_cast<float>(load<std::uint32_t>(row + 4 * k, header.is_big_endian)));
  };
  return {number(0), number(1), header.num_columns == 3 ? number(2) : 0};
}

}  // namespace veritope
