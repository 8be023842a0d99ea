// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_invalid_certifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "models/patch_shapes.h"
#include "robust/base/check.h"
#include "verify/certify/patch_decision.h"
#include "verify/certify/refutation_finding.h"
#include "verify/certify/star_box_certifier.h"
#include "verify/format/byte_stream.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

PatchComplex complex_of(Patches patches) {
  PatchInput input;
  input.patches = std::move(patches);
  return make_patch_complex(std::move(input)).value();
}

// Each patch an entity of its own.
std::vector<StarBoxEntity> entities_of(const PatchComplex& complex, bool is_reversed = false) {
  std::vector<StarBoxEntity> out;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    const bool is_surface = !complex.patch(p).is_triangle();
    out.push_back({is_surface, is_reversed, p, {}});
    if (is_surface) out.back().breaks = {{{0, 1}, {0, 1}}};
  }
  return out;
}

struct Made {
  std::string statement;
  std::vector<unsigned char> body;
};
Made parts_of(const certificate::Bytes& bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), '\n');
  return {std::string(bytes.begin(), end), {end + 1, bytes.end()}};
}
bool says(const Made& made, const std::string& what) {
  return made.statement.find(what) != std::string::npos;
}

struct Decided {
  explicit Decided(Patches patches) : complex(complex_of(std::move(patches))) {
    PatchDecisionOptions options;
    options.tolerance = 1e-2;
    decision = decide_patches(complex, options, &forest);
  }
  PatchComplex complex;
  std::optional<PieceForest> forest;
  PatchDecision decision;
};

Patches crossing_balls() {
  return patch_shapes::joined(
      {patch_shapes::sphere(), patch_shapes::placed(patch_shapes::sphere(), 1, {1, 0, 0})});
}

// The body as the page has it, read field by field.
TEST(PatchInvalidCertificate, OfACrossingHasTheWitness) {
  const Decided d(crossing_balls());
  const auto& w = std::get<CrossingWitness>(*d.decision.refutation);
  const Made made =
      parts_of(make_patch_invalid_certificate(d.complex, w, entities_of(d.complex), {}));
  EXPECT_TRUE(says(made, "\"claim\":\"patch-invalid-1\""));
  EXPECT_TRUE(says(
      made, "\"finding\":\"crossing\",\"patches\":12,\"flipped\":0,\"same\":0,\"opposite\":0}"));
  certificate::internal::ByteReader r(made.body);
  EXPECT_EQ(r.u32(), 0x49505456u);  // VTPI
  EXPECT_EQ(r.u32(), 12u);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(r.u8(), 0u);
  for (int i = 0; i < 24; ++i) {  // breaks 0, 1
    EXPECT_EQ(r.u32(), 2u);
    EXPECT_EQ(r.zigzag(), 0);
    EXPECT_EQ(r.varint(), 1u);
    EXPECT_EQ(r.zigzag(), 1);
    EXPECT_EQ(r.varint(), 1u);
  }
  EXPECT_EQ(r.u8(), 0u);
  for (const PatchRectangle& sheet : w.sheets) {
    EXPECT_EQ(r.varint(), sheet.patch);
    for (const DyadicInterval& t : sheet.at) {
      EXPECT_EQ(r.varint(), t.bits);
      EXPECT_EQ(r.varint(), t.lo);
      EXPECT_EQ(r.varint(), t.hi);
    }
  }
  for (const auto& row : w.rows)
    for (const std::int64_t v : row) EXPECT_EQ(r.zigzag(), v);
  EXPECT_TRUE(r.at_end());
}

TEST(PatchInvalidCertificate, OfSidesHasTheArcs) {
  Patches open = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  open.pop_back();
  const Decided d(open);
  const auto& w = std::get<SideWitness>(*d.decision.refutation);
  const Made made =
      parts_of(make_patch_invalid_certificate(d.complex, w, entities_of(d.complex), {}));
  EXPECT_TRUE(
      says(made, "\"finding\":\"side\",\"patches\":5,\"flipped\":0,\"same\":1,\"opposite\":0}"));
  certificate::internal::ByteReader r(made.body);
  r.raw(4 + 4 + 5 + 10 * (4 + 4));
  EXPECT_EQ(r.u8(), 1u);
  EXPECT_EQ(r.u32(), 1u);
  EXPECT_EQ(r.varint(), w.arcs[0].side.patch);
  EXPECT_EQ(r.u8(), w.arcs[0].side.side);
  for (const std::uint64_t v : {0u, 0u, 1u}) EXPECT_EQ(r.varint(), v);
  EXPECT_EQ(r.u8(), w.axis);
  EXPECT_EQ(r.varint(), w.point_bits);
  EXPECT_EQ(r.varint(), w.point);
  EXPECT_TRUE(r.at_end());
}

// A triangle's side from corner s to corner s + 1 is opposite to corner s + 2, and has its number.
TEST(PatchInvalidCertificate, CountsATrianglesSidesByTheOppositeCorner) {
  Patches open = patch_shapes::pn_torus(12, 8);
  open.erase(open.begin() + 17);
  const Decided d(open);
  const auto& w = std::get<SideWitness>(*d.decision.refutation);
  for (const bool is_reversed : {false, true}) {
    const Made made = parts_of(
        make_patch_invalid_certificate(d.complex, w, entities_of(d.complex, is_reversed), {}));
    certificate::internal::ByteReader r(made.body);
    r.raw(4 + 4 + open.size() + 1 + 4);
    r.varint();
    const std::uint32_t side = w.arcs[0].side.side;
    EXPECT_EQ(r.u8(), ((is_reversed ? 2 - side : side) + 2) % 3);
  }
}

// A witness that proves nothing makes no certificate.
TEST(PatchInvalidCertificate, IsNotMadeOfAFalseWitness) {
  const Decided d(crossing_balls());
  auto w = std::get<CrossingWitness>(*d.decision.refutation);
  const std::vector<StarBoxEntity> entities = entities_of(d.complex);
  std::swap(w.rows[0], w.rows[1]);
  EXPECT_THROW(make_patch_invalid_certificate(d.complex, w, entities, {}), InternalError);
  SideWitness sides;
  sides.arcs.push_back({{0, 0}, DyadicInterval::whole()});
  sides.point_bits = 1, sides.point = 1, sides.same = 1;
  EXPECT_THROW(make_patch_invalid_certificate(d.complex, sides, entities, {}), InternalError);
}

// For reversed entities the certificate names the file's parameters: it is made only if the witness proves it there.
TEST(PatchInvalidCertificate, OfReversedEntitiesIsInTheParametersOfTheFile) {
  for (const Patches& patches :
       {crossing_balls(), patch_shapes::joined({patch_shapes::pn_torus(12, 8),
                                                patch_shapes::placed(patch_shapes::pn_torus(12, 8),
                                                                     1, {3, 0, 0})})}) {
    const Decided d(patches);
    const auto& w = std::get<CrossingWitness>(*d.decision.refutation);
    const Made made =
        parts_of(make_patch_invalid_certificate(d.complex, w, entities_of(d.complex, true), {}));
    EXPECT_TRUE(says(made, "\"flipped\":" + std::to_string(patches.size())));
  }
}

TEST(OuterSides, AreThoseOfTheEntitysBorder) {
  // 2 x 3 pieces, v fastest, then a triangle.
  std::vector<StarBoxEntity> entities{{true, false, 0, {}}, {false, false, 6, {}}};
  entities[0].breaks = {{{0, 1, 2}, {0, 1, 2, 3}}};
  EXPECT_EQ(outer_sides(entities, 7), (OuterSides{1 + 8, 8, 8 + 4, 1 + 2, 2, 2 + 4, 15}));
  entities[0].is_reversed = true;  // side s is side 3 - s
  EXPECT_EQ(outer_sides(entities, 7), (OuterSides{8 + 1, 1, 1 + 2, 8 + 4, 4, 4 + 2, 15}));
}

TEST(RefutationFinding, AreInTheFilesTerms) {
  const Decided d(crossing_balls());
  const Finding f = finding_of(d.complex, entities_of(d.complex), *d.decision.refutation);
  EXPECT_EQ(f.code, "patches-crossing");
  ASSERT_EQ(f.place.parts.size(), 2u);
  ASSERT_TRUE(f.place.near && f.place.box);
  EXPECT_NEAR((*f.place.near)[0], 0.5, 1e-5);  // both unit spheres, about (0, 0, 0) and (1, 0, 0)
  EXPECT_NEAR(std::hypot((*f.place.near)[0], (*f.place.near)[1], (*f.place.near)[2]), 1, 1e-5);
  EXPECT_TRUE(f.place.box->lo[0] <= 0.5 && 0.5 <= f.place.box->hi[0]);

  Patches changed = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  changed[2] = reversed(changed[2]);
  const Decided t(changed);
  EXPECT_EQ(finding_of(t.complex, entities_of(t.complex), *t.decision.refutation).code,
            "side-direction");
  const Decided b(patch_shapes::blocks({{0, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(finding_of(b.complex, entities_of(b.complex), *b.decision.refutation).code,
            "side-overused");
}

// The wrong shell's walk stands last, and the claim is another one.
TEST(ReversedShells, AreRefutedWithTheirWindingNumber) {
  const auto ball = [](int r, int x) {
    return patch_shapes::placed(patch_shapes::sphere(), r, {x, 0, 0});
  };
  const struct {
    Patches patches;
    int winding;
    const char* code;
  } cases[] = {
      {patch_shapes::reversed(ball(1, 0)), 0, "\"winding\":0}"},
      {patch_shapes::joined({ball(2, 0), ball(1, 0)}), 2, "\"winding\":4}"},
      {patch_shapes::joined({ball(2, 0), patch_shapes::reversed(ball(1, 5))}), 0,
       "\"winding\":0}"},
      // A sound ball behind the wrong one in the list of walks.
      {patch_shapes::joined({patch_shapes::reversed(ball(1, 0)), ball(1, 5)}), 0,
       "\"winding\":0}"},
  };
  for (const auto& c : cases) {
    const Decided d(c.patches);
    ASSERT_TRUE(d.decision.refutation) << c.code;
    EXPECT_EQ(std::get<ReversedShell>(*d.decision.refutation).winding, c.winding);
    EXPECT_NE(d.decision.walks.walks.back().winding_inside, 1);
    const Made made = parts_of(make_star_box_certificate(
        *d.forest, d.decision.cover, d.decision.walks, entities_of(d.complex), {}));
    EXPECT_TRUE(says(made, "\"claim\":\"star-box-turned-1\"")) << made.statement;
    EXPECT_TRUE(says(made, "\"bodies\":0")) << made.statement;
    EXPECT_TRUE(says(made, c.code)) << made.statement;
    EXPECT_EQ(finding_of(d.complex, entities_of(d.complex), *d.decision.refutation).code,
              "shell-turned");
  }
}

}  // namespace
}  // namespace veritope
