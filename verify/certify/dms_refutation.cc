// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/dms_refutation.h"

#include <algorithm>
#include <utility>

#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_core.h"
#include "solids/dms/dms_values.h"
#include "verify/certify/certificate_entities.h"

namespace veritope {
namespace {

constexpr std::size_t kMaxProofBytes = 128;  // B2

bool is_short(const certificate::Fraction& x) {
  return std::max(x.numerator.size(), x.denominator.size()) <= kMaxProofBytes;
}
std::string point_words(const DmsPoint& p) {
  return "(" + p[0].to_string() + ", " + p[1].to_string() + ", " + p[2].to_string() + ")";
}
certificate::DmsPointProof proof_of(const DmsPoint& p) {
  return {to_fraction(p[0]), to_fraction(p[1]), to_fraction(p[2])};
}
certificate::DmsFaceName name_of(TetrahedronFace f) {
  return {face_tetrahedron(f), static_cast<std::uint8_t>(face_corner(f))};
}
certificate::DmsIndexName name_of(const TetrahedralIndex& index) {
  certificate::DmsIndexName out{};
  for (std::size_t m = 0; m < 4; ++m) out[m] = static_cast<std::uint8_t>(index[m]);
  return out;
}

// Two faces that are one cyclic order: there are two among three, or among two in one orientation.
certificate::DmsOverusedFace overused_proof(const DmsDefect& defect,
                                            const TetrahedralComplex& complex) {
  const auto turned = [&](TetrahedronFace f) {
    auto v = complex.vertices(f);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    return v;
  };
  for (std::size_t i = 0; i < defect.faces.size(); ++i)
    for (std::size_t k = i + 1; k < defect.faces.size(); ++k)
      if (turned(defect.faces[i]) == turned(defect.faces[k]))
        return {{name_of(defect.faces[i]), name_of(defect.faces[k])}};
  return {};
}
certificate::DmsCloudWithoutCore no_core_proof(const DmsDefect& defect) {
  certificate::DmsCloudWithoutCore out;
  out.tetrahedron = defect.tetrahedra[0];
  for (const DmsCoreWeight& w : defect.weights)
    out.weights.push_back(
        {name_of(w.gamma), static_cast<std::uint8_t>(w.corner), to_fraction(w.weight)});
  return out;
}
certificate::DmsCloudInside inside_proof(const DmsDefect& defect) {
  certificate::DmsCloudInside out;
  const TetrahedronFace f = defect.faces[0];
  out.face = name_of(f);
  for (std::size_t i = 0; i < 3; ++i)
    out.last[i] = static_cast<std::uint8_t>(defect.beta[kTetrahedronFaces[face_corner(f)][i]]);
  out.tetrahedron = defect.tetrahedra[1];
  for (const Rational& w : defect.shares) out.weights.push_back(to_fraction(w));
  return out;
}
certificate::DmsImproperPoint improper_proof(const DmsDefect& defect) {
  certificate::DmsImproperPoint out;
  for (std::size_t i = 0; i < 2; ++i) {
    out.faces[i] = name_of(defect.faces[i]);
    for (std::size_t k = 0; k < 3; ++k) out.weights[i][k] = to_fraction(defect.shares[3 * i + k]);
  }
  return out;
}
certificate::DmsInvalidFinding proof_of(const DmsDefect& defect,
                                        const TetrahedralComplex& complex) {
  switch (defect.fault) {
    case DmsFault::kReversed: return certificate::DmsReversedTetrahedron{defect.tetrahedra[0]};
    case DmsFault::kOverused: return overused_proof(defect, complex);
    case DmsFault::kCrowdedEdge:
      return certificate::DmsCrowdedEdgeName{{defect.vertices[0], defect.vertices[1]}};
    case DmsFault::kPinched: return certificate::DmsPinchedVertexName{defect.vertices[0]};
    case DmsFault::kImproper: return improper_proof(defect);
    case DmsFault::kOverlap:
      return certificate::DmsOverlapPoint{{defect.tetrahedra[0], defect.tetrahedra[1]},
                                          proof_of(*defect.point)};
    case DmsFault::kDegenerate:
      return certificate::DmsDegenerateCloud{defect.tetrahedra[0], name_of(defect.beta)};
    case DmsFault::kNoCore: return no_core_proof(defect);
    case DmsFault::kInside: return inside_proof(defect);
    case DmsFault::kDomainsDiffer: break;  // not of the geometry, and so no finding of this claim
  }
  return {};
}

// Where a parameter of a side of a triangle lies, and a place of its tensor form.
DmsPoint mean(const DmsTile& tile, const std::array<Rational, 3>& shares) {
  DmsPoint out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) out[c] += shares[i] * tile.corners[i][c];
  return out;
}
DmsPoint point_at(const DmsTile& tile, const std::array<Rational, 2>& at) {
  const Rational one(1);
  return mean(tile, {one - at[0], at[0] * (one - at[1]), at[0] * at[1]});
}
DmsPoint point_on_side(const DmsTile& tile, std::uint32_t side, const Rational& at) {
  std::array<Rational, 3> shares;
  shares[side] = Rational(1) - at;
  shares[(side + 1) % 3] = at;
  return mean(tile, shares);
}

DmsPoint middle_of(const std::array<DmsPoint, 4>& corners) {
  DmsPoint out;
  for (const DmsPoint& p : corners)
    for (std::size_t c = 0; c < 3; ++c) out[c] += p[c] * Rational::power_of_two(-2);
  return out;
}

DmsRefutation meeting_of(DmsPoint u, DmsPoint v, std::vector<std::uint32_t> tetrahedra,
                         const char* code) {
  DmsRefutation out;
  out.finding.code = code;
  out.finding.message =
      "the points " + point_words(u) + " and " + point_words(v) + " of the domain have one image";
  out.proof = certificate::DmsMeetingPoints{{proof_of(u), proof_of(v)}};
  out.facts.tetrahedra = std::move(tetrahedra);
  out.facts.parameters = {std::move(u), std::move(v)};
  return out;
}

class SurfaceTranslation {
 public:
  SurfaceTranslation(const std::vector<DmsPiece>& pieces, DmsEvaluator& evaluator)
      : pieces_(pieces), evaluator_(evaluator) {}

  std::optional<DmsRefutation> operator()(const CrossingWitness& w) const {
    certificate::DmsCrossingPieces proof;
    DmsRefutation out;
    for (std::size_t s = 0; s < 2; ++s) {
      const DmsPiece& piece = pieces_[w.sheets[s].patch];
      proof.pieces[s].face = name_of(piece.face);
      for (std::size_t i = 0; i < 3; ++i)
        proof.pieces[s].corners[i] = proof_of(piece.tile.corners[i]);
      proof.pieces[s].planes = proofs_of(piece.tile.planes);
      for (std::size_t k = 0; k < 2; ++k) {
        const DyadicInterval& t = w.sheets[s].at[k];
        proof.at[s][k] = {t.bits, t.lo, t.hi};
      }
      out.facts.tetrahedra.push_back(face_tetrahedron(piece.face));
    }
    proof.rows = w.rows;
    const auto& t = out.facts.tetrahedra;
    out.finding.code = "patches-crossing";
    out.finding.message = "the images of faces of the boundary, of the tetrahedra " +
                          std::to_string(t[0]) + " and " + std::to_string(t[1]) + ", cross";
    out.proof = std::move(proof);
    return out;
  }
  std::optional<DmsRefutation> operator()(const MeetingWitness& w) const {
    const auto& [a, b] = w.places;
    return meeting(a.patch, point_at(pieces_[a.patch].tile, a.at), b.patch,
                   point_at(pieces_[b.patch].tile, b.at), "patches-touching");
  }
  // Two sides that are one curve, or opposite ones, with different arcs of the boundary as preimages.
  std::optional<DmsRefutation> operator()(const SideWitness& w) const {
    const Rational at =
        Rational(w.point) * Rational::power_of_two(-static_cast<std::int64_t>(w.point_bits));
    const PatchSide first = w.arcs[0].side;
    for (std::size_t i = 1; i < w.arcs.size(); ++i)
      for (const Rational& other : {at, Rational(1) - at}) {
        const PatchSide side = w.arcs[i].side;
        if (auto found = meeting(
                first.patch, point_on_side(pieces_[first.patch].tile, first.side, at), side.patch,
                point_on_side(pieces_[side.patch].tile, side.side, other), "patches-touching"))
          return found;
      }
    return std::nullopt;
  }
  std::optional<DmsRefutation> operator()(const ReversedShell&) const { return std::nullopt; }

 private:
  std::optional<DmsRefutation> meeting(std::uint32_t a, DmsPoint u, std::uint32_t b, DmsPoint v,
                                       const char* code) const {
    if (u == v) return std::nullopt;
    const auto values = values_at(evaluator_, std::array{u, v});
    if (!values || (*values)[0] != (*values)[1]) return std::nullopt;
    return meeting_of(std::move(u), std::move(v),
                      {face_tetrahedron(pieces_[a].face), face_tetrahedron(pieces_[b].face)}, code);
  }

  const std::vector<DmsPiece>& pieces_;
  DmsEvaluator& evaluator_;
};

// The images of the tetrahedra of a map of degree 1.
class ImageOverlap {
 public:
  explicit ImageOverlap(const DmsModel& model) : model_(model), knots_(model) {}

  std::optional<DmsRefutation> run() const {
    std::vector<std::array<DmsPoint, 4>> images;
    std::vector<Box3d> boxes;
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) {
      images.push_back(image_of(t));
      boxes.push_back(box_around(images.back()));
    }
    const BoxHierarchy tree(boxes);
    std::optional<DmsRefutation> found;
    for (std::uint32_t i = 0; i < images.size() && !found; ++i)
      tree.visit([&](const Box3d& box) { return !found && meets(box, boxes[i]); },
                 [&](std::uint32_t k) {
                   if (i < k) found = compare(i, images[i], k, images[k]);
                 });
    return found;
  }

 private:
  std::array<DmsPoint, 4> image_of(std::uint32_t t) const {
    std::array<DmsPoint, 4> out;
    for (std::size_t m = 0; m < 4; ++m) {
      const auto value = model_.value(control_of(model_, t, raised({}, m)));
      std::copy_n(value.begin(), 3, out[m].begin());
    }
    return out;
  }
  static bool is_parted(const std::array<DmsPoint, 4>& a, const std::array<DmsPoint, 4>& b) {
    for (const DmsPlane& plane : face_planes(a))
      if (side_of_plane(a, plane) * side_of_plane(b, plane) < 0) return true;
    return false;
  }
  std::optional<DmsRefutation> compare(std::uint32_t i, const std::array<DmsPoint, 4>& a,
                                       std::uint32_t k, const std::array<DmsPoint, 4>& b) const {
    if (is_parted(a, b) || is_parted(b, a)) return std::nullopt;
    auto parted = part_from_tetrahedron(a, b);
    const auto* const common = std::get_if<DmsCommonPoint>(&parted);
    if (common == nullptr) return std::nullopt;
    return meeting_of(preimage(i, a, common->point), preimage(k, b, common->point), {i, k},
                      "patches-crossing");
  }
  DmsPoint preimage(std::uint32_t t, const std::array<DmsPoint, 4>& image,
                    const DmsPoint& p) const {
    const std::array<DmsPoint, 4> corners = knots_.corners(t);
    const DmsMatrix back = linear_part(image, corners);
    const DmsPoint step = difference(p, image[0]);
    DmsPoint out = corners[0];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[i] += back[3 * i + j] * step[j];
    return out;
  }

  const DmsModel& model_;
  const DmsKnotTable knots_;
};

template <typename Point>
bool is_short_point(const Point& p) {
  return std::all_of(p.begin(), p.end(), is_short);
}

}  // namespace

std::vector<certificate::DmsPlaneProof> proofs_of(const std::vector<DmsPlane>& planes) {
  std::vector<certificate::DmsPlaneProof> out;
  for (const DmsPlane& plane : planes) {
    auto& proof = out.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) proof.vector[c] = to_fraction(plane.vector[c]);
    proof.number = to_fraction(plane.number);
  }
  return out;
}

DmsRefutation refutation_of(const DmsDefect& defect, const TetrahedralComplex& complex) {
  DmsRefutation out;
  out.finding.code = fault_name(defect.fault);
  out.finding.message = to_string(defect);
  out.proof = proof_of(defect, complex);
  out.facts.tetrahedra = defect.tetrahedra;
  if (defect.has_beta()) out.facts.beta = defect.beta;
  if (defect.point) out.facts.parameters.push_back(*defect.point);
  return out;
}

std::optional<DmsRefutation> refutation_of(const DmsOpenLeaf& leaf) {
  DmsRefutation out;
  out.finding.code = "jacobian";
  out.facts.tetrahedra = {leaf.tetrahedron};
  if (leaf.negative_at) {
    out.finding.message =
        "the determinant of the derivative is below 0 at " + point_words(*leaf.negative_at);
    out.proof = certificate::DmsNegativePoint{proof_of(*leaf.negative_at)};
    out.facts.parameters = {*leaf.negative_at};
    out.facts.value = leaf.negative_value;
    return out;
  }
  if (!leaf.is_flat) return std::nullopt;
  certificate::DmsFlatLeaf proof;
  proof.tetrahedron = leaf.tetrahedron;
  DmsPoint middle = middle_of(leaf.corners);
  for (std::size_t m = 0; m < 4; ++m) proof.corners[m] = proof_of(leaf.corners[m]);
  out.finding.message = "the determinant of the derivative is 0 everywhere near " +
                        point_words(middle) + ", in tetrahedron " +
                        std::to_string(leaf.tetrahedron);
  out.proof = std::move(proof);
  out.facts.parameters = {std::move(middle)};
  out.facts.value = Rational(0);
  return out;
}

std::optional<DmsRefutation> refutation_of(const PatchRefutation& refutation,
                                           const std::vector<DmsPiece>& pieces,
                                           DmsEvaluator& evaluator) {
  return std::visit(SurfaceTranslation(pieces, evaluator), refutation);
}

DmsRefutation refutation_of(const DmsCoveredPlace& overlap) {
  certificate::DmsCoveringLeaf proof;
  proof.tetrahedron = overlap.tetrahedron;
  for (std::size_t m = 0; m < 4; ++m) proof.corners[m] = proof_of(overlap.corners[m]);
  proof.other = proof_of(overlap.at);
  DmsRefutation out;
  out.finding.code = "patches-crossing";
  out.finding.message = "the point " + point_words(overlap.at) + " of the domain and one near " +
                        point_words(middle_of(overlap.corners)) + " have one image";
  out.proof = std::move(proof);
  out.facts.tetrahedra = {overlap.tetrahedron_of_point, overlap.tetrahedron};
  out.facts.parameters = {overlap.at};
  return out;
}

std::optional<DmsRefutation> find_image_overlap(const DmsModel& model) {
  return ImageOverlap(model).run();
}

bool are_short(const std::vector<certificate::DmsPlaneProof>& planes) {
  return std::all_of(planes.begin(), planes.end(), [](const auto& plane) {
    return is_short_point(plane.vector) && is_short(plane.number);
  });
}

bool has_short_numbers(const certificate::DmsInvalidBody& body) {
  using namespace certificate;
  const auto& finding = body.finding;
  const auto are_short_points = [](const auto& points) {
    return std::all_of(points.begin(), points.end(),
                       [](const auto& p) { return is_short_point(p); });
  };
  if (!std::all_of(body.planes.begin(), body.planes.end(), are_short)) return false;
  if (const auto* const x = std::get_if<DmsCloudWithoutCore>(&finding))
    return std::all_of(x->weights.begin(), x->weights.end(),
                       [](const auto& w) { return is_short(w.weight); });
  if (const auto* const x = std::get_if<DmsCloudInside>(&finding))
    return is_short_point(x->weights);
  if (const auto* const x = std::get_if<DmsNegativePoint>(&finding)) return is_short_point(x->at);
  const auto is_short_part = [&](const DmsPolynomialPart& part) {
    return are_short_points(part.corners) && are_short(part.planes);
  };
  if (const auto* const x = std::get_if<DmsFlatLeaf>(&finding)) return is_short_part(*x);
  if (const auto* const x = std::get_if<DmsCoveringLeaf>(&finding))
    return is_short_part(*x) && is_short_point(x->other);
  if (const auto* const x = std::get_if<DmsImproperPoint>(&finding))
    return are_short_points(x->weights);
  if (const auto* const x = std::get_if<DmsOverlapPoint>(&finding)) return is_short_point(x->at);
  if (const auto* const x = std::get_if<DmsMeetingPoints>(&finding)) return are_short_points(x->at);
  if (const auto* const x = std::get_if<DmsCrossingPieces>(&finding))
    return std::all_of(x->pieces.begin(), x->pieces.end(), [&](const auto& piece) {
      return are_short_points(piece.corners) && are_short(piece.planes);
    });
  return true;
}

}  // namespace veritope
