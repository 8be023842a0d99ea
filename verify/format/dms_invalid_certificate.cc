// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/dms_invalid_certificate.h"

#include <cstddef>
#include <type_traits>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/dms_planes_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;

constexpr std::size_t kNumDmsKinds = std::variant_size_v<DmsInvalidFinding>;
constexpr std::array<std::string_view, kNumDmsKinds> kDmsFindingNames = {"tet-reversed",
                                                                         "tet-face-overused",
                                                                         "cloud-degenerate",
                                                                         "cloud-no-core",
                                                                         "cloud-inside",
                                                                         "jacobian",
                                                                         "jacobian-zero",
                                                                         "M4",
                                                                         "M6",
                                                                         "M7",
                                                                         "M9",
                                                                         "meeting",
                                                                         "crossing",
                                                                         "covering"};

// One layout for writing and reading: put(part) or take(part) for each part in order.
class DmsWriter {
 public:
  explicit DmsWriter(ByteWriter& w) : w_(w) {}
  void name(const std::uint64_t& n) { w_.varint(n); }
  void small(const std::uint8_t& n) { w_.u8(n); }
  void rational(const Fraction& x) { internal::write_fraction(w_, x); }
  void zigzag(const std::int64_t& n) { w_.zigzag(n); }
  void planes(const std::vector<DmsPlaneProof>& list) { internal::write_planes(w_, list); }
  template <typename List>
  void count_in_byte(const List& list) {
    w_.u8(static_cast<std::uint8_t>(list.size()));
  }
  template <typename List>
  void has_size(const List&, std::size_t) {}

 private:
  ByteWriter& w_;
};
class DmsReader {
 public:
  explicit DmsReader(ByteReader& r) : r_(r) {}
  void name(std::uint64_t& n) { n = r_.varint(); }
  void small(std::uint8_t& n) { n = r_.u8(); }
  void rational(Fraction& x) { x = internal::read_fraction(r_); }
  void zigzag(std::int64_t& n) { n = r_.zigzag(); }
  void planes(std::vector<DmsPlaneProof>& list) { list = internal::read_planes(r_); }
  template <typename List>
  void count_in_byte(List& list) {
    list.resize(r_.u8());
  }
  template <typename List>
  void has_size(List& list, std::size_t size) {
    constexpr std::size_t kLeastBytesOfRational = 2;
    if (size > r_.left() / kLeastBytesOfRational) r_.fail();
    if (r_.ok()) list.resize(size);
  }

 private:
  ByteReader& r_;
};

template <typename Io, typename Point>
void lay_point(Io& io, Point& point) {
  for (auto& x : point) io.rational(x);
}
template <typename Io, typename Face>
void lay_face(Io& io, Face& face) {
  io.name(face.tetrahedron);
  io.small(face.number);
}
template <typename Io, typename Part>
void lay_part(Io& io, Part& part) {
  io.name(part.tetrahedron);
  for (auto& p : part.corners) lay_point(io, p);
  io.planes(part.planes);
}

// lay(io, finding): its fields in the order of the page. `Is` names the kind; constness is that of the writer.
template <typename Io, typename Finding>
void lay(Io& io, Finding& x) {
  using Is = std::remove_const_t<Finding>;
  if constexpr (std::is_same_v<Is, DmsReversedTetrahedron>) {
    io.name(x.tetrahedron);
  } else if constexpr (std::is_same_v<Is, DmsOverusedFace>) {
    for (auto& f : x.faces) lay_face(io, f);
  } else if constexpr (std::is_same_v<Is, DmsDegenerateCloud>) {
    io.name(x.tetrahedron);
    for (auto& i : x.index) io.small(i);
  } else if constexpr (std::is_same_v<Is, DmsCloudWithoutCore>) {
    io.name(x.tetrahedron);
    io.count_in_byte(x.weights);
    for (auto& w : x.weights) {
      for (auto& i : w.index) io.small(i);
      io.small(w.corner);
      io.rational(w.weight);
    }
  } else if constexpr (std::is_same_v<Is, DmsCloudInside>) {
    lay_face(io, x.face);
    for (auto& i : x.last) io.small(i);
    io.name(x.tetrahedron);
    io.has_size(x.weights, std::size_t{3} + x.last[0] + x.last[1] + x.last[2]);
    for (auto& w : x.weights) io.rational(w);
  } else if constexpr (std::is_same_v<Is, DmsNegativePoint>) {
    lay_point(io, x.at);
  } else if constexpr (std::is_same_v<Is, DmsFlatLeaf>) {
    lay_part(io, x);
  } else if constexpr (std::is_same_v<Is, DmsCoveringLeaf>) {
    lay_part(io, x);
    lay_point(io, x.other);
  } else if constexpr (std::is_same_v<Is, DmsCrowdedEdgeName>) {
    for (auto& v : x.vertices) io.name(v);
  } else if constexpr (std::is_same_v<Is, DmsPinchedVertexName>) {
    io.name(x.vertex);
  } else if constexpr (std::is_same_v<Is, DmsImproperPoint>) {
    for (auto& f : x.faces) lay_face(io, f);
    for (auto& weights : x.weights) lay_point(io, weights);
  } else if constexpr (std::is_same_v<Is, DmsOverlapPoint>) {
    for (auto& t : x.tetrahedra) io.name(t);
    lay_point(io, x.at);
  } else if constexpr (std::is_same_v<Is, DmsMeetingPoints>) {
    for (auto& p : x.at) lay_point(io, p);
  } else {
    for (auto& piece : x.pieces) {
      lay_face(io, piece.face);
      for (auto& p : piece.corners) lay_point(io, p);
      io.planes(piece.planes);
    }
    for (auto& sheet : x.at)
      for (auto& t : sheet) {
        io.name(t.bits);
        io.name(t.low);
        io.name(t.high);
      }
    for (auto& row : x.rows)
      for (auto& n : row) io.zigzag(n);
  }
}

template <std::size_t... kKinds>
DmsInvalidFinding finding_of_kind(std::size_t kind, std::index_sequence<kKinds...>) {
  DmsInvalidFinding out;
  ((kind == kKinds ? void(out.emplace<kKinds>()) : void()), ...);
  return out;
}

}  // namespace

std::string_view name_of(const DmsInvalidFinding& finding) {
  return kDmsFindingNames[finding.index()];
}
bool needs_planes(const DmsInvalidFinding& finding) {
  return std::holds_alternative<DmsNegativePoint>(finding) ||
         std::holds_alternative<DmsFlatLeaf>(finding) ||
         std::holds_alternative<DmsMeetingPoints>(finding) ||
         std::holds_alternative<DmsCrossingPieces>(finding) ||
         std::holds_alternative<DmsCoveringLeaf>(finding);
}

Bytes encode(const DmsInvalidBody& body) {
  ByteWriter w;
  w.text(kDmsInvalidMagic);
  w.u32(body.tetrahedra);
  w.u8(static_cast<std::uint8_t>(body.finding.index()));
  DmsWriter io(w);
  std::visit([&](const auto& finding) { lay(io, finding); }, body.finding);
  if (!needs_planes(body.finding)) return w.take();
  w.u32(static_cast<std::uint32_t>(body.planes.size()));
  for (const auto& planes : body.planes) internal::write_planes(w, planes);
  return w.take();
}

Bytes encode(const Subject& subject, const DmsInvalidBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kDmsInvalidClaim);
  w.text("body_sha256", to_hex(sha256(bytes)));
  w.text("finding", std::string(name_of(body.finding)));
  w.number("tetrahedra", body.tetrahedra);
  return internal::join(w.take(), bytes);
}

std::optional<DmsInvalidBody> internal::read_dms_invalid(ByteReader r) {
  DmsInvalidBody out;
  r.raw(kDmsInvalidMagic.size());
  out.tetrahedra = r.u32();
  const std::size_t kind = r.u8();
  if (kind >= kNumDmsKinds) return std::nullopt;
  out.finding = finding_of_kind(kind, std::make_index_sequence<kNumDmsKinds>());
  DmsReader io(r);
  std::visit([&](auto& finding) { lay(io, finding); }, out.finding);
  if (needs_planes(out.finding)) {
    out.planes.resize(r.count(1));
    for (auto& planes : out.planes) planes = read_planes(r);
  }
  return r.at_end() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace veritope::certificate
