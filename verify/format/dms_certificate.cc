// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/dms_certificate.h"

#include <algorithm>
#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/dms_planes_internal.h"
#include "verify/format/dms_trees_internal.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::ByteReader;
using internal::ByteWriter;
using internal::read_count;
using internal::read_planes;
using internal::write_planes;

constexpr std::size_t kLeastBytesOfFace = 2, kLeastBytesOfPoint = 6, kLeastBytesOfDmsTile = 4;

}  // namespace

Bytes encode(const DmsBody& body) {
  ByteWriter w;
  w.text(kDmsMagic);
  w.u32(static_cast<std::uint32_t>(body.trees.size()));
  w.u32(static_cast<std::uint32_t>(body.planes.size()));
  w.u32(static_cast<std::uint32_t>(body.points.size()));
  for (const auto& point : body.points)
    for (const Fraction& x : point) internal::write_fraction(w, x);
  internal::write_dms_trees(w, body.trees);
  for (const auto& planes : body.planes) write_planes(w, planes);
  for (const auto& tiles : body.tiles) {
    w.varint(tiles.size());
    for (const DmsTileProof& tile : tiles) {
      for (const std::uint64_t p : tile.points) w.varint(p);
      write_planes(w, tile.planes);
    }
  }
  internal::write_dms_part(w, body.domain);
  internal::write_dms_part(w, body.surface);
  return w.take();
}

Bytes encode(const Subject& subject, const DmsQuantities& q, const DmsBody& body) {
  return internal::dms_certificate(subject, kDmsClaim, q, "patches", encode(body));
}

std::optional<DmsBody> internal::read_dms_body(ByteReader r) {
  DmsBody out;
  r.raw(kDmsMagic.size());
  const std::size_t trees = r.count(internal::kLeastBytesOfTree),
                    faces = r.count(kLeastBytesOfFace);
  out.points.resize(r.count(kLeastBytesOfPoint));
  for (auto& point : out.points)
    for (Fraction& x : point) x = read_fraction(r);
  out.trees = read_dms_trees(r, trees);
  for (std::size_t f = 0; f < faces && r.ok(); ++f) out.planes.push_back(read_planes(r));
  for (std::size_t f = 0; f < faces && r.ok(); ++f) {
    auto& tiles = out.tiles.emplace_back(read_count(r, kLeastBytesOfDmsTile));
    for (DmsTileProof& tile : tiles) {
      for (std::uint64_t& p : tile.points) p = r.varint();
      tile.planes = read_planes(r);
    }
  }
  auto domain = read_dms_part(r);
  if (!domain) return std::nullopt;
  auto surface = read_dms_part(r);
  if (!surface || !r.at_end()) return std::nullopt;
  out.domain = std::move(*domain);
  out.surface = std::move(*surface);
  return out;
}

std::string explain(const DmsBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = "body: " + std::string(claim) + "\n";
  internal::append_dms_trees(out, body.trees, max_items);
  internal::append_list(out, "faces of the boundary", body.tiles.size(), max_items,
                        [&](std::size_t i) {
                          const std::size_t n = std::max<std::size_t>(1, body.tiles[i].size());
                          return std::to_string(n) + (n == 1 ? " tile" : " tiles");
                        });
  out += "the domain as a " + explain(body.domain, kStarBox2Claim, max_items);
  return out + "the surface as a " + explain(body.surface, kStarBox2Claim, max_items);
}

}  // namespace veritope::certificate
