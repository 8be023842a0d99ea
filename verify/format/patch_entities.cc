// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_entities.h"

#include <optional>

#include "verify/format/byte_stream.h"

namespace veritope::certificate {
namespace {

using internal::ByteWriter;

// Nothing if it does not fit 63 bits.
std::optional<std::uint64_t> small(const Natural& n) {
  if (n.size() > 8 || (n.size() == 8 && n.back() >= 128)) return std::nullopt;
  std::uint64_t v = 0;
  for (std::size_t i = n.size(); i-- > 0;) v = v << 8 | n[i];
  return v;
}

void write_fraction(ByteWriter& w, const Fraction& f) {
  const auto p = small(f.numerator), q = small(f.denominator);
  if (p && q) {
    w.zigzag(f.is_negative ? -static_cast<std::int64_t>(*p) : static_cast<std::int64_t>(*p));
    w.varint(*q);
    return;
  }
  w.zigzag(0);
  w.varint(0);
  w.varint(f.numerator.size() + 1);
  w.u8(f.is_negative ? 1 : 0);
  w.raw(f.numerator);
  w.varint(f.denominator.size());
  w.raw(f.denominator);
}

}  // namespace

std::uint64_t num_flipped(const std::vector<PatchEntity>& entities) {
  std::uint64_t n = 0;
  for (const PatchEntity& e : entities) n += e.is_reversed ? 1 : 0;
  return n;
}

void internal::write(ByteWriter& w, const std::vector<PatchEntity>& entities) {
  w.u32(static_cast<std::uint32_t>(entities.size()));
  for (const PatchEntity& e : entities) w.u8(e.is_reversed ? 1 : 0);
  for (const PatchEntity& e : entities) {
    if (!e.is_surface) continue;
    for (const auto& axis : e.breaks) {
      w.u32(static_cast<std::uint32_t>(axis.size()));
      for (const Fraction& f : axis) write_fraction(w, f);
    }
  }
}

}  // namespace veritope::certificate
