// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/vmodel_invalid_certificate.h"

#include <type_traits>

#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

// One function lists the fields of a part, to be written or filled in, so that the two cannot differ.
struct WriteFields {
  ByteWriter& to;
  void varint(const std::uint64_t& v) { to.varint(v); }
  void zigzag(const std::int64_t& v) { to.zigzag(v); }
  void byte(const std::uint8_t& v) { to.u8(v); }
};
struct ReadFields {
  ByteReader& from;
  void varint(std::uint64_t& v) { v = from.varint(); }
  void zigzag(std::int64_t& v) { v = from.zigzag(); }
  void byte(std::uint8_t& v) { v = from.u8(); }
};

template <class T, class Plain>
concept Like = std::is_same_v<std::remove_const_t<T>, Plain>;

template <class F, Like<CellPoint> T>
void cell_fields(F& f, T& x) {
  f.varint(x.cell);
  for (auto& t : x.at) f.varint(t.piece), f.varint(t.at.numerator), f.varint(t.at.denominator);
}
template <class F, Like<SpanInterval> T>
void cell_fields(F& f, T& x) {
  f.varint(x.piece), f.varint(x.at.bits), f.varint(x.at.low), f.varint(x.at.high);
}
template <class F, Like<CellOverlap::Somewhere> T>
void cell_fields(F& f, T& x) {
  f.varint(x.box.cell);
  for (auto& t : x.box.at) cell_fields(f, t);
  for (auto& row : x.rows)
    for (auto& v : row) f.zigzag(v);
}
template <class F, Like<FlatCell> T>
void cell_fields(F& f, T& x) {
  f.varint(x.cell);
  for (auto& piece : x.pieces) f.varint(piece);
}
template <class F, Like<LeftHandedCell> T>
void cell_fields(F& f, T& x) {
  cell_fields(f, x.at);
}
template <class F, Like<SingularPoint> T>
void cell_fields(F& f, T& x) {
  cell_fields(f, x.at);
}
template <class F, Like<CrowdedCurve> T>
void cell_fields(F& f, T& x) {
  for (auto& arc : x.arcs) {
    f.varint(arc.cell), f.byte(arc.face), f.byte(arc.side);
    cell_fields(f, arc.at);
  }
}
template <class F, Like<PinchedPoint> T>
void cell_fields(F& f, T& x) {
  f.varint(x.cell), f.byte(x.corner);
}

void write_finding(ByteWriter& w, const CellOverlap& x) {
  WriteFields f{w};
  cell_fields(f, x.inside);
  w.u8(static_cast<std::uint8_t>(x.other.index()));
  std::visit([&](const auto& other) { cell_fields(f, other); }, x.other);
}
template <class Finding>
void write_finding(ByteWriter& w, const Finding& x) {
  WriteFields f{w};
  cell_fields(f, x);
}

template <class T>
T read_fields(ByteReader& r) {
  T out;
  ReadFields f{r};
  cell_fields(f, out);
  return out;
}
CellOverlap read_overlap(ByteReader& r) {
  CellOverlap out;
  out.inside = read_fields<CellPoint>(r);
  const std::uint8_t kind = r.u8();
  if (kind > 1) r.fail();
  if (kind == 0)
    out.other = read_fields<CellPoint>(r);
  else
    out.other = read_fields<CellOverlap::Somewhere>(r);
  return out;
}
VModelInvalidFinding read_finding(ByteReader& r, std::uint8_t kind) {
  switch (kind) {
    case 0: return read_fields<FlatCell>(r);
    case 1: return read_fields<LeftHandedCell>(r);
    case 2: return read_fields<SingularPoint>(r);
    case 3: return read_overlap(r);
    case 4: return read_fields<CrowdedCurve>(r);
    case 5: return read_fields<PinchedPoint>(r);
    default: r.fail(); return FlatCell{};
  }
}

}  // namespace

std::string_view name_of(const VModelInvalidFinding& finding) {
  constexpr std::array<std::string_view, 6> kNames = {
      "flat", "left-handed", "singular", "overlap", "curve-nonmanifold", "point-nonmanifold"};
  return kNames[finding.index()];
}

Bytes encode(const VModelInvalidBody& body) {
  ByteWriter w;
  w.text(kVModelInvalidMagic);
  w.u32(body.cells);
  w.u8(static_cast<std::uint8_t>(body.finding.index()));
  std::visit([&](const auto& finding) { write_finding(w, finding); }, body.finding);
  return w.take();
}

Bytes encode(const Subject& subject, const VModelInvalidBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kVModelInvalidClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.text("finding", name_of(body.finding));
  w.number("cells", body.cells);
  return internal::join(w.take(), bytes);
}

std::optional<VModelInvalidBody> internal::read_vmodel_invalid(ByteReader r) {
  VModelInvalidBody out;
  r.raw(kVModelInvalidMagic.size());
  out.cells = r.u32();
  out.finding = read_finding(r, r.u8());
  return r.at_end() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace veritope::certificate
