// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/write_mesh.h"
#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"
#include "tests/certify/certify_answers.h"
#include "tests/certify/zero_shapes.h"
#include "tests/support/shapes.h"
#include "verify/certify/file_patches.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

std::string bytes_of(const Patches& patches) { return spline_json_bytes(model_of(patches)); }
std::string bytes_of(const TriangleMesh& mesh) {
  return mesh_to_bytes(mesh, *write_options_from_name("ply-ascii")).value();
}

Certified certify_patches(const Patches& patches, const CertifyOptions& options = {}) {
  return certify(read(bytes_of(patches), "model.vjson"), options).value();
}

patch_shapes::Shape broken_shape(const std::string& name) {
  for (patch_shapes::Shape& shape : patch_shapes::broken_shapes())
    if (shape.name == name) return shape;
  return {};
}

TEST(Certify, AMeshIsValidOrInvalidAndItsCertificateIsAccepted) {
  const std::string box = bytes_of(shapes::box({0, 0, 0}, {1, 2, 3}));
  const Certified valid = certify(read(box, "box.ply")).value();
  EXPECT_EQ(valid.verdict, Verdict::kValid);
  EXPECT_EQ(valid.claim, "mesh-valid-1");
  EXPECT_TRUE(valid.findings.empty());
  EXPECT_EQ(std::get<MeshFacts>(valid.facts).decision.counts.faces, 12u);

  const std::string backward = bytes_of(shapes::reversed(shapes::box({0, 0, 0}, {1, 2, 3})));
  const Certified invalid = certify(read(backward, "box.ply")).value();
  EXPECT_EQ(invalid.verdict, Verdict::kInvalid);
  EXPECT_EQ(invalid.claim, "mesh-invalid-1");
  ASSERT_EQ(invalid.findings.size(), 1u);
  EXPECT_EQ(invalid.findings[0].code, "M8");
  EXPECT_FALSE(invalid.certificate.empty());
}

TEST(Certify, AMeshWhoseFacesRunTheWrongWayIsValidOnceTheyAreReversed) {
  TriangleMesh mixed = shapes::nested_boxes(2);
  std::swap(mixed.faces[3][1], mixed.faces[3][2]);
  CertifyOptions options;
  for (const TriangleMesh& mesh : {shapes::reversed(shapes::nested_boxes(3)), mixed}) {
    const std::string file = bytes_of(mesh);
    options.orientation = PatchOrientation::kKeep;
    EXPECT_EQ(certify(read(file, "a.ply"), options).value().claim, "mesh-invalid-1");
    options.orientation = PatchOrientation::kAuto;
    const Certified c = certify(read(file, "a.ply"), options).value();
    EXPECT_EQ(c.verdict, Verdict::kValid);
    EXPECT_EQ(c.claim, "mesh-reversed-1");
    EXPECT_TRUE(c.findings.empty());
    const MeshFacts& facts = std::get<MeshFacts>(c.facts);
    EXPECT_TRUE(facts.decision.is_valid);
    ASSERT_TRUE(facts.reversal);
    EXPECT_EQ(facts.reversal->faces, facts.reversal->whole_shells == 0 ? 1u : 36u);
    expect_accepted(file, c);
    options.jobs = 4;
    EXPECT_EQ(certify(read(file, "a.ply"), options).value().certificate, c.certificate);
    options.jobs = 1;
  }
}

TEST(Certify, MeshesThatReversingDoesNotHelpAreTakenAsTheyAre) {
  TriangleMesh open = shapes::reversed(shapes::box({0, 0, 0}, {1, 2, 3}));
  open.faces.pop_back();
  for (const TriangleMesh& mesh : {shapes::box({0, 0, 0}, {1, 2, 3}), open}) {
    const std::string file = bytes_of(mesh);
    CertifyOptions options;
    const Certified as_is = certify(read(file, "a.ply"), options).value();
    options.orientation = PatchOrientation::kAuto;
    const Certified c = certify(read(file, "a.ply"), options).value();
    EXPECT_EQ(c.certificate, as_is.certificate);
    EXPECT_EQ(c.findings.size(), as_is.findings.size());
    EXPECT_FALSE(std::get<MeshFacts>(c.facts).reversal);
  }
}

TEST(Certify, FindingsOfMeshesAreListedForEachRuleAndTheCertificateDoesNotDependOnThem) {
  TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  mesh.faces.push_back(mesh.faces[0]);
  mesh.faces.push_back(mesh.faces[1]);
  CertifyOptions options;
  options.max_findings = 2;
  const Certified two = certify(read(bytes_of(mesh), "two.ply"), options).value();
  std::vector<std::string> codes;
  for (const Finding& f : two.findings) codes.push_back(f.code);
  EXPECT_EQ(codes, (std::vector<std::string>{"M2", "M2", "M4", "M4", "M7", "M7"}));
  options.max_findings = 0;
  const Certified none = certify(read(bytes_of(mesh), "two.ply"), options).value();
  EXPECT_TRUE(none.findings.empty());
  EXPECT_EQ(none.certificate, two.certificate);
}

TEST(Certify, TheCertificateSpeaksOfTheBytesAndTheTool) {
  const std::string file = bytes_of(patch_shapes::sphere());
  CertifyOptions options;
  options.tool = "a test";
  const ModelFile model = read(file, "ball.vjson");
  const Certified c = certify(model, options).value();
  const std::string text(c.certificate.begin(), c.certificate.end());
  EXPECT_NE(text.find(sha256_of(model)), std::string::npos);
  EXPECT_NE(text.find("\"tool\":\"a test\""), std::string::npos) << text.substr(0, 300);
  expect_accepted(file, c);
}

TEST(Certify, PatchesAreValidInvalidOrUndecided) {
  const std::string ball = bytes_of(patch_shapes::sphere());
  const Certified valid = certify(read(ball, "ball.vjson")).value();
  EXPECT_EQ(valid.verdict, Verdict::kValid);
  EXPECT_EQ(valid.claim, "star-box-1");
  EXPECT_EQ(patch_facts(valid).bodies, 1u);
  expect_accepted(ball, valid);

  Patches open = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  open.pop_back();
  const std::string file = bytes_of(open);
  const Certified invalid = certify(read(file, "open.vjson")).value();
  EXPECT_EQ(invalid.verdict, Verdict::kInvalid);
  EXPECT_EQ(invalid.claim, "patch-invalid-1");
  ASSERT_EQ(invalid.findings.size(), 1u);
  EXPECT_EQ(invalid.findings[0].code, "side-open");
  EXPECT_TRUE(invalid.findings[0].witness.point.has_value());
  expect_accepted(file, invalid);

  const Patches balls = patch_shapes::joined(
      {patch_shapes::sphere(), patch_shapes::placed(patch_shapes::sphere(), 1, {2, 0, 0})});
  const Certified tangent = certify_patches(balls);
  EXPECT_EQ(tangent.verdict, Verdict::kInvalid);
  EXPECT_EQ(tangent.claim, "patch-invalid-2");
  ASSERT_EQ(tangent.findings.size(), 1u);
  EXPECT_EQ(tangent.findings[0].code, "patches-touching");
  EXPECT_EQ(tangent.findings[0].place.near.value(), (Point3d{1, 0, 0}));
  expect_accepted(bytes_of(balls), tangent);

  const Certified touching =
      certify_patches(broken_shape("lid-touching-in-an-irrational-line").patches);
  expect_undecided(touching, "not-certified", "two sheets ");
  EXPECT_LT(touching.findings[0].witness.approx_distance.value(), 1e-6);
  EXPECT_EQ(touching.findings[0].place.parts.size(), 2u);
  EXPECT_TRUE(touching.findings[0].place.box.has_value());
  EXPECT_TRUE(touching.findings[0].place.source.entity.has_value());
  EXPECT_EQ(patch_facts(touching).shells, 2u);
}

TEST(Certify, PhasesAreReportedInTheirOrder) {
  CertifyOptions options;
  std::vector<Phase> seen;
  options.on_phase = [&](Phase phase) { seen.push_back(phase); };
  options.with_collar = true;
  certify_patches(patch_shapes::sphere(), options);
  EXPECT_EQ(seen, (std::vector{Phase::kDeciding, Phase::kSeekingCollar, Phase::kCertifying}));
}

TEST(Certify, StepsOfKnownAmountEndWithTheWholeOfIt) {
  CertifyOptions options;
  WorkShare work;
  options.work = &work;
  double done = 0;
  options.on_phase = [&](Phase phase) {
    EXPECT_EQ(work.view().percent(), std::nullopt) << "between phases no step runs";
    EXPECT_EQ(work.view().done, work.view().whole);
    if (phase == Phase::kCertifying) done = work.view().done;
    work.reset();
  };
  certify_patches(patch_shapes::sphere(), options);
  EXPECT_EQ(done, 6) << "the patches that are covered";
  const std::string box = bytes_of(shapes::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(certify(read(box, "box.ply"), options).value().verdict, Verdict::kValid);
  EXPECT_GT(done, 0) << "the comparisons of faces";
  EXPECT_GT(work.view().done, 0) << "the parts of the walk that is certified";
  EXPECT_EQ(work.view().done, work.view().whole);
}

TEST(Certify, ACollarIsPartOfTheClaimIfOneIsFound) {
  CertifyOptions options;
  options.with_collar = true;
  const std::string ball = bytes_of(patch_shapes::sphere());
  const Certified c = certify(read(ball, "ball.vjson"), options).value();
  EXPECT_EQ(c.claim, "collar-1");
  ASSERT_TRUE(patch_facts(c).collar.has_value());
  EXPECT_FALSE(patch_facts(c).collar->open.has_value());
  expect_accepted(ball, c);

  // So far away that cells around the origin's grid are too coarse: the frame that fits the model has an origin of its own.
  const Rational one(1), far = Rational::power_of_two(45);
  const Patches distant =
      affine_image(patch_shapes::sphere(),
                   {3, 3, {one, 0, 0, 0, one, 0, 0, 0, one}, {far, 0, one / Rational(3)}})
          .value();
  const Certified without = certify_patches(distant, options);
  EXPECT_EQ(without.verdict, Verdict::kValid);
  EXPECT_EQ(without.claim, "star-box-1");
  ASSERT_TRUE(patch_facts(without).collar && patch_facts(without).collar->open);
  EXPECT_EQ(patch_facts(without).collar->open->code, "no-collar");
}

// Where normals are zero at corners, the star boxes need version 2, and so does the collar. Beside thin walls, which boxes
// with several sheets hold, none is sought.
TEST(Certify, CollarsHaveTheVersionOfTheirStarBoxes) {
  CertifyOptions options;
  options.with_collar = true;
  const std::string section = bytes_of(zero_shapes::round_prism());
  const Certified c = certify(read(section, "section.vjson"), options).value();
  EXPECT_EQ(c.claim, "collar-2");
  ASSERT_TRUE(patch_facts(c).collar && !patch_facts(c).collar->open);
  expect_accepted(section, c);
  EXPECT_FALSE(c.without_collar.empty());

  const AffineMap turn{3, 3, {2, -1, 2, 2, 2, -1, -1, 2, 2}, {0, 0, 0}};
  const Certified thin = certify_patches(
      affine_image(patch_shapes::box({0, 0, 0}, {1, 1, Rational::power_of_two(-20)}), turn).value(),
      options);
  EXPECT_EQ(thin.verdict, Verdict::kValid);
  ASSERT_TRUE(patch_facts(thin).collar && patch_facts(thin).collar->open);
  EXPECT_EQ(patch_facts(thin).collar->open->code, "no-collar");
}

// A model whose fitted frame is another than the plain one still gets a collar where the plain frame costs little more.
TEST(Certify, ThePlainFrameIsTriedAgainForACollar) {
  const Rational one(1), flat = Rational::power_of_two(-4);
  const Patches egg =
      affine_image(patch_shapes::sphere(), {3, 3, {one, 0, 0, 0, one, 0, 0, 0, flat}, {8, 0, 0}})
          .value();
  FilePatches patches = file_patches(model_of(egg), PatchOrientation::kKeep).value();
  EXPECT_FALSE(decide_file_patches(patches, {}).forest->frame().is_plain());
  CertifyOptions options;
  options.with_collar = true;
  EXPECT_EQ(certify_patches(egg, options).claim, "collar-1");
}

TEST(Certify, OrientationIsMendedOnlyWhenAskedFor) {
  Patches changed = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  changed[2] = reversed(changed[2]);
  EXPECT_EQ(certify_patches(changed).findings.at(0).code, "side-direction");
  CertifyOptions options;
  options.orientation = PatchOrientation::kAuto;
  const std::string file = bytes_of(changed);
  const Certified mended = certify(read(file, "box.vjson"), options).value();
  EXPECT_EQ(mended.verdict, Verdict::kValid);
  EXPECT_EQ(patch_facts(mended).reversed, (std::vector<std::uint64_t>{2}));
  expect_accepted(file, mended);
}

// Which shells are inside out takes winding numbers to see: the patches of each fit together.
TEST(Certify, ShellsThatAreInsideOutAreTurnedAsAWhole) {
  Patches backward;
  for (const Patch& p : patch_shapes::sphere()) backward.push_back(reversed(p));
  const Certified wrong = certify_patches(backward);
  EXPECT_EQ(wrong.verdict, Verdict::kInvalid);
  EXPECT_EQ(wrong.claim, "star-box-turned-1");
  EXPECT_EQ(wrong.findings.at(0).witness.winding, 0);
  CertifyOptions options;
  options.orientation = PatchOrientation::kAuto;
  const std::string file = bytes_of(backward);
  const Certified mended = certify(read(file, "ball.vjson"), options).value();
  EXPECT_EQ(mended.verdict, Verdict::kValid);
  EXPECT_EQ(patch_facts(mended).reversed.size(), backward.size());
  expect_accepted(file, mended);
}

// kAuto is named only where it mends all that is known to be wrong.
TEST(Certify, OrientationIsRecommendedOnlyWhereItHelps) {
  const Patches box = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  CertifyOptions oriented;
  oriented.orientation = PatchOrientation::kAuto;
  const auto helps = [](const Patches& patches, const char* code, const CertifyOptions& options) {
    const Certified c = certify_patches(patches, options);
    EXPECT_EQ(c.findings.empty() ? "" : c.findings.back().code, code);
    return patch_facts(c).auto_helps;
  };
  Patches turned = box;
  turned[2] = reversed(turned[2]);
  EXPECT_TRUE(helps(turned, "side-direction", {}));
  EXPECT_FALSE(helps(turned, "", oriented));
  Patches backward;
  for (const Patch& p : box) backward.push_back(reversed(p));
  EXPECT_TRUE(helps(backward, "shell-turned", {}));
  EXPECT_FALSE(helps(backward, "", oriented));
  EXPECT_FALSE(helps(box, "", {}));

  // Besides a turned patch, an open side, or a second box that crosses the first.
  Patches open = turned;
  open.pop_back();
  EXPECT_FALSE(helps(open, "side-open", {}));
  Patches crossing = turned;
  for (const Patch& p : patch_shapes::box(
           {Rational(1) / Rational(2), Rational(1) / Rational(4), Rational(1) / Rational(4)},
           {2, Rational(3) / Rational(4), Rational(3) / Rational(4)}))
    crossing.push_back(p);
  EXPECT_FALSE(helps(crossing, "side-direction", {}));

  // Around each wrong shell another one ends its walk, so that no certificate can name it; kAuto reverses both.
  Patches nested;
  for (const auto& [lo, is_inward] : {std::pair{0, false}, {2, false}, {4, true}, {6, true}})
    for (const Patch& p : patch_shapes::box({lo, lo, lo}, {16 - lo, 16 - lo, 16 - lo}))
      nested.push_back(is_inward ? reversed(p) : p);
  EXPECT_TRUE(helps(nested, "not-certified", {}));
  EXPECT_FALSE(helps(nested, "", oriented));
}

// A file of bilinear surfaces: the faces of boxes between z = 0 and z = 1, some of them missing.
class Boxes {
 public:
  // The lid of a box from x0 to x0 + 1, a surface with the knot 1/2 twice: it may jump there.
  Boxes& torn_lid(const std::string& x0, const std::string& left, const std::string& right,
                  const std::string& x1) {
    return add("\"0\", \"0\", \"1/2\", \"1/2\", \"1\", \"1\"", {{x0, "0", "1"},
                                                                {x0, "1", "1"},
                                                                {left, "0", "1"},
                                                                {left, "1", "1"},
                                                                {right, "0", "1"},
                                                                {right, "1", "1"},
                                                                {x1, "0", "1"},
                                                                {x1, "1", "1"}});
  }
  Boxes& surface(const std::string& knots, const std::vector<std::array<std::string, 3>>& points) {
    return add(knots, points);
  }
  // Without lid; with a bottom only if asked for.
  Boxes& cup(int x0, bool has_bottom = true, bool is_reversed = false) {
    const std::string a = std::to_string(x0), b = std::to_string(x0 + 1);
    if (has_bottom)
      face({{{a, "0", "0"}, {b, "0", "0"}, {a, "1", "0"}, {b, "1", "0"}}}, is_reversed);
    face({{{b, "0", "0"}, {b, "0", "1"}, {b, "1", "0"}, {b, "1", "1"}}}, is_reversed);
    face({{{a, "0", "0"}, {a, "1", "0"}, {a, "0", "1"}, {a, "1", "1"}}}, is_reversed);
    face({{{a, "1", "0"}, {b, "1", "0"}, {a, "1", "1"}, {b, "1", "1"}}}, is_reversed);
    face({{{a, "0", "0"}, {a, "0", "1"}, {b, "0", "0"}, {b, "0", "1"}}}, is_reversed);
    return *this;
  }
  std::string bytes() const {
    return "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [" + entities_ + "]}";
  }
  SplineFile file(const ReadLimits& limits = {}) const {
    ModelReadOptions options;
    options.limits = limits;
    return std::get<SplineFile>(read(bytes(), "boxes.vjson", options));
  }
  Certified certified(const CertifyOptions& options = {}) const {
    return certify(file(), options).value();
  }

 private:
  using Point = std::array<std::string, 3>;
  void face(std::array<Point, 4> points, bool is_reversed) {
    if (is_reversed) std::swap(points[1], points[2]);
    add("\"0\", \"0\", \"1\", \"1\"", {points.begin(), points.end()});
  }
  Boxes& add(const std::string& knots, const std::vector<Point>& points) {
    std::string list;
    for (const Point& p : points)
      list += (list.empty() ? "[\"" : ", [\"") + p[0] + "\", \"" + p[1] + "\", \"" + p[2] + "\"]";
    entities_ += (entities_.empty() ? "" : ", ") +
                 std::string(
                     "{\"kind\": \"surface\", \"group\": null, \"attributes\": [], \"shape\": {"
                     "\"degrees\": [1, 1], \"periodic\": [false, false], \"knots\": [[") +
                 knots +
                 "], [\"0\", \"0\", \"1\", \"1\"]], \"rational\": false, \"components\": 3, " +
                 "\"points\": [" + list + "]}}";
    return *this;
  }
  std::string entities_;
};

CertifyOptions oriented() {
  CertifyOptions out;
  out.orientation = PatchOrientation::kAuto;
  return out;
}

// A knot of a multiplicity above the degree: the surface may be in pieces there, and what is true of pieces need not be of surfaces.
TEST(Certify, ATornSurfaceIsNeverRefuted) {
  const Boxes whole = Boxes().torn_lid("0", "1/2", "1/2", "1").cup(0);
  const Certified valid = whole.certified();
  EXPECT_EQ(valid.verdict, Verdict::kValid);
  expect_accepted(whole.bytes(), valid);
  expect_undecided(Boxes().torn_lid("0", "1/2", "1/2", "1").cup(0, false).certified(),
                   "knot-multiplicity",
                   "above its degree: u = 1/2 of entity 0, where the surface could");
}

// Nine bilinear patches around three triangles, the last joined to the first with its corners in the other order: closed, and one-sided.
void add_klein_bottle(Boxes& file) {
  const auto corner = [](int i, int j) {
    if (i == 3) i = 0, j = 3 - j;
    const int size = i + 1;
    return std::array<std::string, 3>{std::to_string(10 + i), std::to_string(j % 3 == 1 ? size : 0),
                                      std::to_string(j % 3 == 2 ? size : 0)};
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      file.surface("\"0\", \"0\", \"1\", \"1\"",
                   {corner(i, j), corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1)});
}

// "These normals disagree" is not a fact about the file once some were reversed: here the lid of the box was.
TEST(Certify, ARefutationOfReversedNormalsIsNone) {
  Boxes file;
  file.cup(0).surface("\"0\", \"0\", \"1\", \"1\"",
                      {{"0", "0", "1"}, {"1", "0", "1"}, {"0", "1", "1"}, {"1", "1", "1"}});
  add_klein_bottle(file);
  EXPECT_EQ(file.certified().findings.at(0).code, "side-direction");
  EXPECT_FALSE(patch_facts(file.certified()).auto_helps);
  expect_undecided(file.certified(oriented()), "not-certified",
                   "with the entities that were reversed side");
}

TEST(Certify, OtherRefutationsStandAfterPatchesWereReversed) {
  Patches changed = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  changed.pop_back();
  changed[2] = reversed(changed[2]);
  const Certified open = certify_patches(changed, oriented());
  EXPECT_EQ(open.verdict, Verdict::kInvalid);
  EXPECT_EQ(open.findings.at(0).code, "side-open");
}

// Certificates reverse whole entities: here one half of a surface is the lid of a box, the other half that of an inside-out one.
TEST(Certify, HalvesOfASurfaceAreNotReversedOneByOne) {
  const Boxes mixed = Boxes().torn_lid("0", "1", "3", "4").cup(0).cup(3, true, true);
  expect_undecided(mixed.certified(oriented()), "not-covered",
                   "pieces of entity 0 would have to be reversed one by one");
}

// Law: the checkers accept the certificate with the copy, which has the surfaces of the file.
TEST(Certify, OfShapesThatTheCheckersDoNotReadACopyIsCertified) {
  SplineFile file = Boxes().torn_lid("0", "1/2", "1/2", "1").cup(0).file();
  for (const SplineFormat format : {SplineFormat::kG2, SplineFormat::kGismo}) {
    file.format = format;
    file.has_converted_shapes = format == SplineFormat::kG2;
    const Certified c = certify(file).value();
    EXPECT_EQ(c.verdict, Verdict::kValid);
    ASSERT_TRUE(c.copy);
    EXPECT_FALSE(c.boundary_faces);
    EXPECT_EQ(format_of_certificate(c), "vjson");
    EXPECT_EQ(c.copy->what, "its " + std::to_string(file.model.entities.size()) + " surfaces");
    EXPECT_FALSE(c.copy->is_of_volumes);
    expect_accepted(c.copy->bytes, c);
    const ModelFile copy = read(c.copy->bytes, "copy.vjson");
    EXPECT_EQ(sha256_of(copy), c.copy->sha256);
    EXPECT_EQ(std::get<SplineFile>(copy).model, file.model);
  }
}

// The copy has the entities of the file in their order, so that findings about it are findings about the file.
TEST(Certify, FindingsAboutACopyOfSurfacesHaveTheNumbersOfTheFile) {
  const std::string head = "200 1 0 0 3 0 2 2 0 0 1 1 2 2 0 0 1 1";
  const std::string floor = head + " 0 0 0 0 1 0 1 0 0 1 1 0\n";
  const std::string lid = "250 1 0 0 3 0 0 1 0 0 1 1 0 0 1 0 1 0 1 0\n";
  const Certified two = certify(read(lid + floor, "two.g2")).value();
  ASSERT_TRUE(two.copy);
  EXPECT_EQ(two.verdict, Verdict::kInvalid);
  expect_accepted(two.copy->bytes, two);
  const auto& at = patch_facts(two).open_sides;
  ASSERT_EQ(at.size(), 8u);
  for (const OpenSideFacts& side : at)
    for (const Point3d& end : side.side.ends) EXPECT_EQ(end[2], side.part.entity == 0 ? 1 : 0);

  const std::string gismo =
      "<xml>\n<Geometry type=\"TensorBSpline2\" id=\"7\">\n<Basis type=\"TensorBSplineBasis2\">\n"
      "<Basis type=\"BSplineBasis\" index=\"0\"><KnotVector degree=\"1\">0 0 1 "
      "1</KnotVector></Basis>\n"
      "<Basis type=\"BSplineBasis\" index=\"1\"><KnotVector degree=\"1\">0 0 1 "
      "1</KnotVector></Basis>\n"
      "</Basis>\n<coefs geoDim=\"3\">0 0 Z 1 0 Z 0 1 Z 1 1 Z</coefs>\n</Geometry>\n";
  std::string both;
  for (const std::string z : {"3", "5"}) {
    std::string one = gismo.substr(6);
    for (std::size_t i; (i = one.find('Z')) != one.npos;) one.replace(i, 1, z);
    one.replace(one.find("id=\"7"), 5, z == "3" ? "id=\"7" : "id=\"2");
    both += one;
  }
  const Certified sheets = certify(read("<xml>\n" + both + "</xml>\n", "two.xml")).value();
  ASSERT_TRUE(sheets.copy);
  ASSERT_EQ(patch_facts(sheets).open_sides.size(), 8u);
  for (const OpenSideFacts& side : patch_facts(sheets).open_sides)
    EXPECT_EQ(side.side.ends[0][2], side.part.entity == 0 ? 3 : 5);
}

// The checkers glue at most a patch for every three bytes: of a shorter file a contact of corners has no certificate.
TEST(Certify, ContactsOfCornersNeedAFileThatIsLongEnough) {
  const auto verdict_of = [](const Patches& patches, std::uint64_t bytes) {
    ModelFile file = read(bytes_of(patches), "boxes.vjson");
    std::get<SplineFile>(file).bytes = bytes;
    return certify(file).value().verdict;
  };
  const Patches corners = broken_shape("boxes-touching-in-a-vertex").patches,
                faces = broken_shape("boxes-touching-in-a-face").patches;
  EXPECT_EQ(verdict_of(corners, 36), Verdict::kInvalid);
  EXPECT_EQ(verdict_of(corners, 35), Verdict::kUndecided);
  EXPECT_EQ(verdict_of(faces, 35), Verdict::kInvalid) << "a place inside of a face needs no gluing";
}

// A cube of planes that the reader makes into surfaces, and the same cube as splines.
TEST(Certify, SurfacesOfG2AreCertifiedAsTheyStandUnlessTheyAreConverted) {
  const auto corner = [](int i) {
    return std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2);
  };
  std::string splines;
  for (const std::array<int, 4>& f : {std::array{0, 2, 1, 3},
                                      {4, 5, 6, 7},
                                      {0, 1, 4, 5},
                                      {2, 6, 3, 7},
                                      {0, 4, 2, 6},
                                      {1, 3, 5, 7}}) {
    splines += "200 1 0 0 3 0 2 2 0 0 1 1 2 2 0 0 1 1";
    for (const int c : f) splines += " " + corner(c);
    splines += "\n";
  }
  const Certified own = certify(read(splines, "cube.g2")).value();
  EXPECT_EQ(own.verdict, Verdict::kValid);
  EXPECT_FALSE(own.copy);
  EXPECT_EQ(format_of_certificate(own), "g2");
  expect_accepted(splines, own);
  const std::string plane = "250 1 0 0 3 0 0 1 0 0 1 1 0 0 1 0 1 0 1 0\n";  // z = 1
  const std::size_t lid = splines.find("200 1", 1);
  const std::string mixed =
      splines.substr(0, lid) + plane + splines.substr(splines.find("200 1", lid + 1));
  const Certified copied = certify(read(mixed, "cube.g2")).value();
  EXPECT_EQ(copied.verdict, Verdict::kValid);
  ASSERT_TRUE(copied.copy);
  EXPECT_EQ(format_of_certificate(copied), "vjson");
  expect_accepted(copied.copy->bytes, copied);
}

TEST(Certify, ShapesThatAreNotReadAreNotCovered) {
  SplineFile file = Boxes().torn_lid("0", "1/2", "1/2", "1").cup(0).file();
  file.left_out.push_back({"matrices", "", false, 1});
  EXPECT_EQ(certify(file).value().verdict, Verdict::kValid);
  file.left_out.push_back({"polygons", "", true, 1});
  expect_undecided(certify(file).value(), "not-covered",
                   "shapes of the file are not read: polygons (1)");
}

TEST(Certify, CurvesAreNotCovered) {
  const std::string with_curve =
      "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [{\"kind\": \"curve\", "
      "\"group\": null, \"attributes\": [], \"shape\": {\"degrees\": [1], \"periodic\": [false], "
      "\"knots\": [[\"0\", \"0\", \"1\", \"1\"]], \"rational\": false, \"components\": 3, "
      "\"points\": [[\"0\", \"0\", \"0\"], [\"1\", \"0\", \"0\"]]}}]}";
  expect_undecided(certify(read(with_curve, "curve.vjson")).value(), "not-covered",
                   "the file has 1 curve: such shapes bound no solid");
}

// A knot with 700 decimals takes more than the 2048 bits of a certificate; a coordinate of 1,200 more than the default limits of readers.
TEST(Certify, LongNumbersAreNotCovered) {
  const std::string knot = "0." + std::string(699, '3') + "1",
                    long_number = "0." + std::string(1200, '3');
  const auto lid = [](const std::string& knots, const std::string& middle) {
    return Boxes()
        .surface(knots, {{"0", "0", "1"},
                         {"0", "1", "1"},
                         {middle, "0", "1"},
                         {middle, "1", "1"},
                         {"1", "0", "1"},
                         {"1", "1", "1"}})
        .cup(0);
  };
  expect_undecided(lid("\"0\", \"0\", \"" + knot + "\", \"1\", \"1\"", knot).certified(),
                   "not-covered", "entity 0 has longer knots");
  ReadLimits wide;
  wide.max_digits = 2000;
  const Boxes digits = lid("\"0\", \"0\", \"1/2\", \"1\", \"1\"", long_number);
  expect_undecided(certify(digits.file(wide)).value(), "not-covered",
                   "longer numbers than certificates may be about: ");
  EXPECT_FALSE(Boxes().cup(0).file(wide).beyond_default_limits.has_value());
  // A copy has other lines than the file: the place is that in the file. Fractions may be longer than decimals.
  wide.max_digits = 6000;
  SplineFile copied =
      lid("\"0\", \"0\", \"1/2\", \"1\", \"1\"", "0." + std::string(5200, '3')).file(wide);
  copied.format = SplineFormat::kGismo;
  ASSERT_TRUE(copied.beyond_default_limits);
  copied.beyond_default_limits->place.line = 77;
  expect_undecided(certify(copied).value(), "not-covered", "about: line 77");
  copied.beyond_default_limits.reset();
  expect_undecided(certify(copied).value(), "not-covered", "about: entity 0: ");
}

TEST(Certify, AFileWithoutAModelOfItsKindIsAnError) {
  const std::string curve = "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": []}";
  const Result<ModelFile> file = read_model_bytes(
      {reinterpret_cast<const unsigned char*>(curve.data()), curve.size()}, "none.vjson", {});
  ASSERT_TRUE(file.has_value()) << to_string(file.error());
  const Result<Certified> c = certify(*file);
  ASSERT_FALSE(c.has_value());
  EXPECT_EQ(c.error().code, Code::kEmpty);
  const Result<Certified> no_face = certify(ModelFile());
  ASSERT_FALSE(no_face.has_value());
  EXPECT_EQ(no_face.error().code, Code::kEmpty);
}

TEST(Certify, OptionsOutsideTheirRangesAreErrors) {
  const ModelFile cube = read(bytes_of(patch_shapes::box({0, 0, 0}, {1, 1, 1})), "cube.vjson");
  const auto code_of = [&](const CertifyOptions& options) {
    const Result<Certified> c = certify(cube, options);
    return c ? std::optional<Code>() : c.error().code;
  };
  CertifyOptions options;
  options.tool = std::string(200, 'x');
  EXPECT_EQ(code_of(options), std::nullopt);
  for (const std::string& tool : {std::string(201, 'x'), std::string("a\"b"), std::string("a\\b"),
                                  std::string("a\nb"), std::string("\xc3\xa9")}) {
    options.tool = tool;
    EXPECT_EQ(code_of(options), Code::kBadArgument) << tool;
  }
  options.tool = tool_name();
  for (const double tolerance : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.tolerance = tolerance;
    EXPECT_EQ(code_of(options), Code::kBadArgument) << tolerance;
  }
}

}  // namespace
}  // namespace veritope
