// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/points_certificate.h"

#include <utility>

#include "verify/format/byte_stream.h"
#include "verify/format/sha256.h"
#include "verify/format/statement_writer.h"

namespace veritope::certificate {

using internal::ByteReader;
using internal::ByteWriter;

PatchCodes::PatchCodes(const std::vector<PatchEntity>& entities)
    : writer_(std::make_unique<ByteWriter>()) {
  for (const PatchEntity& e : entities)
    if (e.is_surface) internal::write_breaks(*writer_, e);
}
PatchCodes::PatchCodes(PatchCodes&&) noexcept = default;
PatchCodes::~PatchCodes() = default;

void PatchCodes::add_direction(std::uint8_t code) { writer_->u8(code); }

namespace {

constexpr std::uint8_t kRationalParameters = 0, kAlgebraicParameters = 1;
constexpr std::uint8_t kDirections = 6, kOn = 12, kOpen = 13, kUncovered = 14;  // of expressions

void write_polynomial(ByteWriter& w, const std::vector<Fraction>& coefficients) {
  w.u8(static_cast<std::uint8_t>(coefficients.size() - 1));
  for (const Fraction& f : coefficients) internal::write_fraction(w, f);
}

void write(ByteWriter& w, const AlgebraicPointOnPatch& place) {
  w.varint(place.patch);
  w.u8(kAlgebraicParameters);
  write_polynomial(w, place.modulus);
  for (const Fraction& f : place.interval) internal::write_fraction(w, f);
  for (const auto& polynomial : place.parameters) write_polynomial(w, polynomial);
}

void write(ByteWriter& w, const PointOnPatch& place) {
  w.varint(place.patch);
  w.u8(kRationalParameters);
  for (const Fraction& f : place.parameters) internal::write_fraction(w, f);
}

}  // namespace

void PatchCodes::add(const AlgebraicPointOnPatch& place) { write(*writer_, place); }
void PatchCodes::add(const PointOnPatch& place) { write(*writer_, place); }

Bytes PatchCodes::take() { return writer_->take(); }

ExpressionHeader::ExpressionHeader(std::uint64_t num_uncovered)
    : writer_(std::make_unique<ByteWriter>()) {
  writer_->u32(static_cast<std::uint32_t>(num_uncovered));
  writer_->u32(static_cast<std::uint32_t>(num_uncovered >> 32));
}
ExpressionHeader::ExpressionHeader(ExpressionHeader&&) noexcept = default;
ExpressionHeader::~ExpressionHeader() = default;

void ExpressionHeader::add_mesh(std::uint32_t num_faces, std::uint32_t num_vertex_ids) {
  writer_->u32(num_faces);
  writer_->u32(num_vertex_ids);
}

void ExpressionHeader::add_patches(bool by_faces, std::uint32_t num_patches,
                                   const std::vector<PatchEntity>& entities) {
  writer_->u8(by_faces ? 1 : 0);
  writer_->u32(num_patches);
  writer_->u32(static_cast<std::uint32_t>(entities.size()));
  for (const PatchEntity& e : entities)
    if (e.is_surface) internal::write_breaks(*writer_, e);
}

Bytes ExpressionHeader::take() { return writer_->take(); }

ExpressionCodes::ExpressionCodes() : writer_(std::make_unique<ByteWriter>()) {}
ExpressionCodes::ExpressionCodes(ExpressionCodes&&) noexcept = default;
ExpressionCodes::~ExpressionCodes() = default;

void ExpressionCodes::add_off(bool is_inside, std::uint8_t direction) {
  writer_->u8(static_cast<std::uint8_t>(is_inside ? kDirections + direction : direction));
}
void ExpressionCodes::add_on(std::uint32_t facet) {
  writer_->u8(kOn);
  writer_->varint(facet);
}
void ExpressionCodes::add_on(const PointOnPatch& place) {
  writer_->u8(kOn);
  write(*writer_, place);
}
void ExpressionCodes::add_on(const AlgebraicPointOnPatch& place) {
  writer_->u8(kOn);
  write(*writer_, place);
}
void ExpressionCodes::add_open() { writer_->u8(kOpen); }
void ExpressionCodes::add_uncovered() { writer_->u8(kUncovered); }
Bytes ExpressionCodes::take() { return writer_->take(); }

Bytes encode(const PointsBody& body) {
  ByteWriter w;
  w.reserve(body.codes.size() + 32);
  w.text(kPointsMagic);
  w.u32(body.num_faces);
  w.u32(body.num_vertex_ids);
  w.u32(static_cast<std::uint32_t>(body.num_points));
  w.u32(static_cast<std::uint32_t>(body.num_points >> 32));
  w.raw(body.codes);
  return w.take();
}

Bytes encode(const Subject& subject, const AnswersSubject& answers, const PointsBody& body) {
  const Bytes bytes = encode(body);
  internal::StatementWriter w;
  internal::state_subject(w, subject, kPointsClaim);
  w.text("reading_rule", subject.reading_rule);
  w.boolean("as_indexed", subject.as_indexed);
  w.text("answers_sha256", answers.sha256);
  w.number("answers_bytes", answers.bytes);
  w.text("decimals", answers.are_decimals_exact ? "exact" : "nearest");
  w.boolean("winding", answers.is_winding);
  w.number("points", answers.points);
  w.number("on", answers.on);
  w.number("undecided", answers.undecided);
  w.text("body_sha256", to_hex(sha256(bytes)));
  return internal::join(w.take(), bytes);
}

std::optional<PointsBody> internal::read_points(ByteReader r) {
  PointsBody out;
  r.raw(4);
  out.num_faces = r.u32();
  out.num_vertex_ids = r.u32();
  out.num_points = r.u32();
  out.num_points |= std::uint64_t{r.u32()} << 32;
  const auto codes = r.raw(r.left());
  out.codes.assign(codes.begin(), codes.end());
  if (!r.at_end()) return std::nullopt;
  return out;
}

std::string explain(const PointsBody& body, std::string_view claim, std::size_t) {
  return "body: " + std::string(claim) + ", " + std::to_string(body.num_faces) + " triangles, " +
         std::to_string(body.num_vertex_ids) +
         " vertex ids (of a spline model: patches, entities; of an expression: solids, "
         "operands), " +
         std::to_string(body.num_points) + " points\n" + std::to_string(body.codes.size()) +
         " bytes of directions and triangles or places on patches, whose meaning depends on the "
         "words of the answers\n";
}

}  // namespace veritope::certificate
