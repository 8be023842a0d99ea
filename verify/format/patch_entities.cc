// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_entities.h"

#include <optional>

#include "verify/format/byte_stream.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

constexpr std::uint8_t kOther = 0, kSurface = 1, kTriangle = 2;  // in bodies of version 2

// Nothing if the number does not fit 63 bits.
std::optional<std::uint64_t> small(const Natural& n) {
  if (n.size() > 8 || (n.size() == 8 && n.back() >= 128)) return std::nullopt;
  std::uint64_t v = 0;
  for (std::size_t i = n.size(); i-- > 0;) v = v << 8 | n[i];
  return v;
}

Natural natural(std::uint64_t v) {
  Natural n;
  for (; v != 0; v >>= 8) n.push_back(static_cast<unsigned char>(v));
  return n;
}

Natural read_natural(ByteReader& r, std::uint64_t size) {
  if (size > r.left()) r.fail();
  const auto bytes = r.ok() ? r.raw(size) : std::span<const unsigned char>();
  return Natural(bytes.begin(), bytes.end());
}

}  // namespace

Fraction internal::read_fraction(ByteReader& r) {
  const std::int64_t p = r.zigzag();
  const std::uint64_t q = r.varint();
  if (q != 0)
    return {p < 0,
            natural(p < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(p)
                          : static_cast<std::uint64_t>(p)),
            natural(q)};
  Fraction f;
  const std::uint64_t size = r.varint();  // bytes of the sign and the numerator
  if (size == 0) r.fail();
  f.is_negative = r.u8() == 1;
  f.numerator = read_natural(r, size == 0 ? 0 : size - 1);
  f.denominator = read_natural(r, r.varint());
  return f;
}

std::uint64_t num_reversed(const std::vector<PatchEntity>& entities) {
  std::uint64_t n = 0;
  for (const PatchEntity& e : entities) n += e.is_reversed ? 1 : 0;
  return n;
}

namespace {

void read_breaks(ByteReader& r, PatchEntity& e) {
  for (auto& axis : e.breaks) {
    const std::uint32_t n = r.count(2);
    if (n < 2) r.fail();
    for (std::uint32_t k = 0; k < n && r.ok(); ++k) axis.push_back(internal::read_fraction(r));
  }
}

}  // namespace

void internal::write_fraction(ByteWriter& w, const Fraction& f) {
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

void internal::write_breaks(ByteWriter& w, const PatchEntity& e) {
  for (const auto& axis : e.breaks) {
    w.u32(static_cast<std::uint32_t>(axis.size()));
    for (const Fraction& f : axis) write_fraction(w, f);
  }
}

void internal::write(ByteWriter& w, const std::vector<PatchEntity>& entities) {
  w.u32(static_cast<std::uint32_t>(entities.size()));
  for (const PatchEntity& e : entities) w.u8(e.is_reversed ? 1 : 0);
  for (const PatchEntity& e : entities)
    if (e.is_surface) write_breaks(w, e);
}

bool internal::read(ByteReader& r, const std::vector<bool>& is_surface,
                    std::vector<PatchEntity>& out) {
  out.assign(r.count(1), PatchEntity());
  if (!r.ok() || out.size() != is_surface.size()) return false;
  for (PatchEntity& e : out) e.is_reversed = r.u8() == 1;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].is_surface = is_surface[i];
    if (is_surface[i]) read_breaks(r, out[i]);
  }
  return r.ok();
}

void internal::write_with_kinds(ByteWriter& w, const std::vector<PatchEntity>& entities) {
  w.u32(static_cast<std::uint32_t>(entities.size()));
  for (const PatchEntity& e : entities) {
    w.u8(e.is_other ? kOther : e.is_surface ? kSurface : kTriangle);
    w.u8(e.is_reversed ? 1 : 0);
  }
  for (const PatchEntity& e : entities)
    if (e.is_surface) write_breaks(w, e);
}

bool internal::read_with_kinds(ByteReader& r, std::vector<PatchEntity>& out) {
  out.assign(r.count(2), PatchEntity());
  for (PatchEntity& e : out) {
    const std::uint8_t kind = r.u8(), flag = r.u8();
    if (kind > kTriangle || flag > 1) r.fail();
    e.is_surface = kind == kSurface;
    e.is_other = kind == kOther;
    e.is_reversed = flag == 1;
  }
  for (PatchEntity& e : out)
    if (e.is_surface && r.ok()) read_breaks(r, e);
  return r.ok();
}

}  // namespace veritope::certificate
