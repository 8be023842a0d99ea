// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/dms_certifier.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "interval/upward.h"
#include "io/splines/spline_model.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_face_pairs.h"
#include "solids/dms/dms_hulls.h"
#include "solids/dms/dms_jacobian.h"
#include "solids/dms/dms_surface.h"
#include "solids/dms/dms_tiles.h"
#include "solids/dms/fast/fold_search.h"
#include "solids/dms/fast/overlap_search.h"
#include "solids/pieces/patch_volume.h"
#include "verify/certify/certificate_entities.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/dms_refutation.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/refutation_finding.h"
#include "verify/certify/star_box_certifier.h"
#include "verify/format/dms_certificate.h"

namespace veritope {
namespace {

// B2 of the page.
constexpr int kMaxCertifiedDegree = 6;
constexpr std::size_t kMaxCertifiedBits = 256, kMaxPointBytes = 128;
// How much is tried for a proof by star boxes. A tile takes some milliseconds, and a box one.
struct SurfaceLimits {
  std::size_t tiles = static_cast<std::size_t>(-1);
  std::size_t boxes = StarCoverOptions().max_boxes;
};
// More is tried only if pairs of faces prove nothing. Where the surface nearly folds, ten tiles may need 30,000 boxes.
constexpr SurfaceLimits kBeforePairs{500, 2000};
// After a proof by pairs, tiles give the volume if they are no more.
constexpr std::size_t kTilesForVolume = 2000;
constexpr double kVolumeTolerance = 1e-5;  // for rational patches; these are polynomial

std::string text_of(const DmsPoint& p) {
  return "(" + p[0].to_string() + ", " + p[1].to_string() + ", " + p[2].to_string() + ")";
}
bool is_long(const Rational& x) {
  return std::max(x.numerator().bit_length(), x.denominator().bit_length()) > kMaxCertifiedBits;
}

// A refutation of triangles, with what is to be said if it says nothing of the solid.
struct SurfaceFault {
  Finding finding;
  std::optional<PatchRefutation> refutation;
  bool is_over_limit = false;  // of boxes
};
// What star boxes say of triangles that bound a solid.
struct SurfaceProof {
  certificate::StarBoxBody boxes;
  std::uint64_t bodies = 0;
  std::vector<std::uint64_t> genera;  // of the shells
  std::optional<Interval> volume;
};

class DmsCertification {
 public:
  DmsCertification(const DmsModel& model, const certificate::Subject& subject,
                   const CertifyOptions& options)
      : model_(model),
        subject_(subject),
        options_(options),
        complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())),
        facts_(dms_facts_of(model)) {}

  Certified run() {
    internal::enter(Phase::kDeciding, options_);
    auto reason = decide();
    if (!reason && !refutations_.empty()) reason = refute();
    if (reason) {
      out_.findings.assign(1, std::move(*reason));
    } else if (refutations_.empty()) {
      internal::enter(Phase::kCertifying, options_);
      const certificate::DmsQuantities quantities{
          facts_.tetrahedra,
          facts_.control_points,
          facts_.leaves,
          pairs_ ? facts_.faces : facts_.patches,
          facts_.genera.size(),
          facts_.bodies,
          std::accumulate(facts_.genera.begin(), facts_.genera.end(), std::uint64_t{0})};
      out_.certificate = pairs_ ? certificate::encode(subject_, quantities, *pairs_)
                                : certificate::encode(subject_, quantities, body_);
      out_.claim = pairs_ ? certificate::kDms2Claim : certificate::kDmsClaim;
      out_.verdict = Verdict::kValid;
    }
    out_.facts = facts_;
    return std::move(out_);
  }

 private:
  static Finding reason(std::string message, const char* code = "not-certified") {
    Finding out;
    out.code = code;
    out.message = std::move(message);
    return out;
  }

  // INVALID by the first refutation, or why its certificate cannot be written.
  std::optional<Finding> refute() {
    certificate::DmsInvalidBody body;
    body.tetrahedra = static_cast<std::uint32_t>(model_.tetrahedra.size());
    body.finding = refutations_.front().proof;
    if (certificate::needs_planes(body.finding)) body.planes = body_.planes;
    if (!has_short_numbers(body))
      return reason(refutations_.front().finding.message + "; but its proof has too many bits",
                    "not-covered");
    internal::enter(Phase::kCertifying, options_);
    out_.certificate = certificate::encode(subject_, body);
    out_.claim = certificate::kDmsInvalidClaim;
    out_.verdict = Verdict::kInvalid;
    for (DmsRefutation& r : refutations_) {
      out_.findings.push_back(std::move(r.finding));
      facts_.defects.push_back(std::move(r.facts));
    }
    facts_.num_defects = std::max<std::uint64_t>(num_defects_, out_.findings.size());
    return std::nullopt;
  }

  // What is not decided; else all is proved, or there is a refutation.
  std::optional<Finding> decide() {
    if (find_defects()) return std::nullopt;
    if (auto found = decide_geometry(); found || !refutations_.empty()) return found;
    return attribute_domain();
  }
  std::optional<Finding> decide_geometry() {
    if (auto found = long_numbers()) return found;
    if (auto found = separate_control()) return found;
    if (auto found = hulls()) return found;
    auto open = decide_map();
    if (!open || !refutations_.empty()) return std::nullopt;
    auto overlap = find_overlap(model_);
    if (!overlap) return open;
    refutations_.push_back(refutation_of(*overlap));
    return std::nullopt;
  }
  std::optional<Finding> decide_map() {
    if (auto open = jacobian(); open || !refutations_.empty()) {
      // The surface needs no derivatives to meet itself.
      bool is_over_limit = false;
      if (open) surface_by_tiles(kBeforePairs, is_over_limit);
      return open;
    }
    if (model_.degree == 1)
      if (auto found = find_image_overlap(model_)) {
        refutations_.push_back(std::move(*found));
        return std::nullopt;
      }
    if (auto found = domain()) return found;
    return surface();
  }

  bool find_defects() {
    const DmsDefects defects =
        find_geometry_defects(model_, std::max<std::size_t>(1, options_.max_findings));
    num_defects_ = defects.count;
    for (const DmsDefect& defect : defects.first)
      refutations_.push_back(refutation_of(defect, complex_));
    return defects.count > 0;
  }

  // The certificate is about the map alone, but a model whose attributes have no sound domain is not called VALID.
  std::optional<Finding> attribute_domain() const {
    const DmsDefects defects = find_attribute_defects(model_, 1);
    if (defects.count == 0) return std::nullopt;
    const DmsDefect& first = defects.first[0];
    return reason(std::string(fault_name(first.fault)) + ": " + to_string(first), "not-covered");
  }

  std::optional<Finding> long_numbers() const {
    bool is_too_long = false;
    for (const DmsCloud& cloud : model_.clouds)
      for (const DmsPoint& knot : cloud)
        is_too_long |= std::any_of(knot.begin(), knot.end(), is_long);
    for (std::size_t i = 0; i < model_.num_control(); ++i) {
      const auto value = model_.value(i);
      is_too_long |= std::any_of(value.begin(), value.begin() + 3, is_long);
    }
    if (model_.degree > kMaxCertifiedDegree)
      return reason("certificates speak of degrees up to " + std::to_string(kMaxCertifiedDegree),
                    "not-covered");
    if (is_too_long)
      return reason("a number has more than " + std::to_string(kMaxCertifiedBits) + " bits",
                    "not-covered");
    return std::nullopt;
  }

  static SplineModel spline_model(std::vector<ExactTriangle> triangles) {
    SplineModel out;
    for (ExactTriangle& t : triangles) out.entities.push_back({std::move(t), {}, std::nullopt, {}});
    return out;
  }
  // Proves that triangles bound a solid, or says what is against it.
  std::variant<SurfaceProof, SurfaceFault> prove_surface(std::vector<ExactTriangle> triangles,
                                                         const std::string& what,
                                                         const SurfaceLimits& limits) const {
    const SplineModel model = spline_model(std::move(triangles));
    Result<FilePatches> patches = file_patches(model, PatchOrientation::kKeep);
    if (!patches)
      return SurfaceFault{reason(what + ": " + patches.error().message, "not-covered"), {}};
    FileDecisionOptions how;
    if (options_.max_cells) how.search.cover.max_boxes = *options_.max_cells;
    const bool is_limited = limits.boxes < how.search.cover.max_boxes;
    if (is_limited) how.search.cover.max_boxes = limits.boxes;
    const FileDecision decided = decide_file_patches(*patches, how);
    const PatchDecision& d = decided.decision;
    if (!d.is_valid) {
      const Finding why =
          d.refutation ? finding_of(*patches->complex, patches->entities, *d.refutation) : *d.open;
      return SurfaceFault{reason(what + ": " + why.code + ": " + why.message), d.refutation,
                          is_limited && why.code == open_code::kBudget};
    }
    if (!fits_certificate(*decided.forest, d.cover))
      return SurfaceFault{
          reason(what + ": the star boxes have coordinates too long for a certificate",
                 "not-covered"),
          {}};
    SurfaceProof out;
    out.boxes = make_star_box_2_body(*decided.forest, d.cover, d.walks, patches->entities);
    out.bodies = d.bodies;
    for (const PatchShellFacts& s : d.shells)
      out.genera.push_back(static_cast<std::uint64_t>(s.genus));
    out.volume = d.volume;
    return out;
  }
  static ExactTriangle triangle_of(int degree, std::span<const DmsPoint> coefficients) {
    ExactTriangle out(degree, 3, false);
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < coefficients.size(); ++i)
        out.component(c)[i] = coefficients[i][static_cast<std::size_t>(c)];
    return out;
  }
  std::vector<DmsPoint> corners_of_face(TetrahedronFace f) const {
    std::vector<DmsPoint> out;
    for (const std::uint32_t v : complex_.vertices(f)) out.push_back(model_.knot(v, 0));
    return out;
  }

  std::optional<Finding> domain() {
    std::vector<ExactTriangle> triangles;
    for (const TetrahedronFace f : complex_.boundary())
      triangles.push_back(triangle_of(1, corners_of_face(f)));
    auto proved = prove_surface(std::move(triangles), "the boundary of the domain", {});
    if (auto* const fault = std::get_if<SurfaceFault>(&proved)) return std::move(fault->finding);
    domain_ = std::get<SurfaceProof>(std::move(proved));
    return std::nullopt;
  }

  std::optional<Finding> separate_control() const {
    if (!model_.control.is_separate) return std::nullopt;
    const auto differs = find_disagreeing_control(model_);
    if (!differs) return std::nullopt;
    return reason("E1: control points of tetrahedron " + std::to_string(*differs) +
                  " differ from those of others at the same vertices");
  }

  std::optional<Finding> hulls() {
    auto planes = part_hulls(model_, complex_);
    if (const auto* const open = std::get_if<DmsOpenHull>(&planes)) {
      const auto v = complex_.vertices(open->face);
      return reason("E3: knots of the face (" + std::to_string(v[0]) + ", " + std::to_string(v[1]) +
                    ", " + std::to_string(v[2]) + ") may lie inside of tetrahedron " +
                    std::to_string(open->tetrahedron));
    }
    for (const auto& of_face : std::get<0>(planes)) body_.planes.push_back(proofs_of(of_face));
    if (std::all_of(body_.planes.begin(), body_.planes.end(), are_short)) return std::nullopt;
    return reason("B2: planes that part knots have too many bits", "not-covered");
  }

  // Tetrahedra before the first one are proved.
  std::optional<DmsRefutation> refutation_by_samples(std::uint32_t first) const {
    auto fold = find_fold(model_, first);
    if (!fold) return std::nullopt;
    DmsOpenLeaf leaf;
    leaf.tetrahedron = fold->tetrahedron;
    leaf.negative_at = std::move(fold->at);
    leaf.negative_value = std::move(fold->determinant);
    return refutation_of(leaf);
  }

  std::optional<Finding> jacobian() {
    auto trees = prove_jacobian(model_);
    if (const auto* const open = std::get_if<DmsOpenLeaf>(&trees)) {
      auto refuted = refutation_of(*open);
      if (!refuted) refuted = refutation_by_samples(open->tetrahedron);
      if (refuted) {
        refutations_.push_back(std::move(*refuted));
        return std::nullopt;
      }
      std::string text =
          "J: the determinant of the derivative is not proved to be above 0 in tetrahedron " +
          std::to_string(open->tetrahedron) + ", with the corners ";
      for (std::size_t i = 0; i < 4; ++i) text += (i == 0 ? "" : ", ") + text_of(open->corners[i]);
      return reason(std::move(text));
    }
    trees_ = std::get<0>(std::move(trees));
    for (const DmsLeafTree& tree : trees_) {
      auto& proof = body_.trees.emplace_back();
      for (const auto& node : tree) {
        if (const auto* const cut = std::get_if<DmsEdgeCut>(&node)) {
          proof.emplace_back(
              certificate::DmsCutProof{static_cast<std::uint8_t>(cut->edge), std::nullopt});
          continue;
        }
        const DmsLeaf& leaf = std::get<DmsLeaf>(node);
        certificate::DmsLeafProof out;
        out.is_polynomial = leaf.is_polynomial;
        for (std::size_t i = 0; i < 9; ++i) out.matrix[i] = to_fraction(leaf.matrix[i]);
        proof.emplace_back(std::move(out));
        ++facts_.leaves;
      }
    }
    return std::nullopt;
  }

  std::optional<Finding> surface() {
    bool is_over_limit = false;
    auto open = surface_by_tiles(kBeforePairs, is_over_limit);
    if ((!open && !is_over_limit) || surface_by_pairs()) return std::nullopt;
    return is_over_limit ? surface_by_tiles({}, is_over_limit) : open;
  }

  // Nothing is found, and nothing open, if there would be more tiles or boxes.
  std::optional<Finding> surface_by_tiles(const SurfaceLimits& limits, bool& is_over_limit) {
    body_.tiles.clear();
    body_.points.clear();
    numbers_.clear();
    DmsTileOptions how{std::max(1u, options_.jobs), options_.work};
    how.max_tiles = limits.tiles;
    auto tiled = tile_boundary(model_, complex_, how);
    if (const auto* const open = std::get_if<DmsOpenFace>(&tiled)) {
      is_over_limit = open->is_over_limit;
      if (is_over_limit) return std::nullopt;
      const auto v = complex_.vertices(open->face);
      return reason("T2: the face (" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                    std::to_string(v[2]) +
                    ") of the boundary is not cut into parts that no triangle of knots meets");
    }
    DmsEvaluator evaluator(model_);
    std::vector<DmsTile> all;
    std::vector<DmsPiece> pieces;
    for (const auto& tiles : std::get<0>(tiled)) {
      const TetrahedronFace face = complex_.boundary()[body_.tiles.size()];
      add_tiles(tiles);
      for (const DmsTile& tile : tiles) {
        pieces.push_back({face, tile});
        all.push_back(tile);
      }
    }
    if (has_long_points()) return reason("B2: corners of tiles have too many bits", "not-covered");
    auto proved =
        prove_surface(patches_on(model_, evaluator, all, how), "the surface of the solid", limits);
    if (auto* const fault = std::get_if<SurfaceFault>(&proved)) {
      is_over_limit = fault->is_over_limit;
      if (is_over_limit) return std::nullopt;
      if (!fault->refutation) return std::move(fault->finding);
      auto refuted = refutation_of(*fault->refutation, pieces, evaluator);
      if (!refuted) return std::move(fault->finding);
      refutations_.push_back(std::move(*refuted));
      return std::nullopt;
    }
    auto& surface = std::get<SurfaceProof>(proved);
    if (surface.bodies != domain_.bodies || surface.genera != domain_.genera)
      return reason("W3: the surface of the solid is not that of the domain");
    facts_.patches = all.size();
    facts_.bodies = surface.bodies;
    facts_.genera = std::move(surface.genera);
    facts_.volume = surface.volume;
    body_.domain = std::move(domain_.boxes);
    body_.surface = std::move(surface.boxes);
    return std::nullopt;
  }

  // Whether bodies have one shell each, and blocks and pairs of faces prove the map to be one to one on the boundary.
  bool surface_by_pairs() {
    if (domain_.genera.size() != domain_.bodies) return false;
    auto proved =
        prove_face_pairs(model_, complex_, trees_, {std::max(1u, options_.jobs), options_.work});
    const auto* const found = std::get_if<DmsFacePairs>(&proved);
    if (found == nullptr) return false;
    certificate::DmsPairsBody& body = pairs_.emplace();
    for (const DmsBlock& block : found->blocks) body.blocks.push_back(proof_of(block));
    for (const DmsFacePair& pair : found->pairs) body.pairs.push_back(proof_of(pair));
    body.trees = std::move(body_.trees);
    body.planes = std::move(body_.planes);
    body.domain = std::move(domain_.boxes);
    facts_.faces = complex_.boundary().size();
    facts_.bodies = domain_.bodies;
    facts_.genera = domain_.genera;
    facts_.volume = volume_by_tiles();
    return true;
  }
  // The volume within the image of the boundary. REQUIRES that the map is proved to be one to one.
  std::optional<Interval> volume_by_tiles() const {
    DmsTileOptions how{std::max(1u, options_.jobs), options_.work};
    how.max_tiles = kTilesForVolume;
    const auto tiled = tile_boundary(model_, complex_, how);
    if (tiled.index() != 0) return std::nullopt;
    std::vector<DmsTile> all;
    for (const auto& tiles : std::get<0>(tiled)) all.insert(all.end(), tiles.begin(), tiles.end());
    const DmsEvaluator evaluator(model_);
    const SplineModel model = spline_model(patches_on(model_, evaluator, all, how));
    const Result<FilePatches> patches = file_patches(model, PatchOrientation::kKeep);
    if (!patches || !patches->complex || !patches->complex->is_closed_oriented_surface())
      return std::nullopt;
    Result<PieceForest> forest = PieceForest::make(*patches->complex);
    if (!forest) return std::nullopt;
    const std::vector<Interval> volumes = shell_volumes(*forest, kVolumeTolerance);
    const ScopedUpward upward;
    Interval sum;
    for (const Interval& v : volumes) sum += v;
    return sum;
  }
  static certificate::DmsBlockProof proof_of(const DmsBlock& block) {
    certificate::DmsBlockProof out;
    out.tetrahedra.assign(block.tetrahedra.begin(), block.tetrahedra.end());
    for (std::size_t i = 0; i < 9; ++i) out.matrix[i] = to_fraction(block.matrix[i]);
    return out;
  }
  static certificate::DmsPairProof proof_of(const DmsFacePair& pair) {
    certificate::DmsPairProof out;
    out.first = pair.first;
    out.second = pair.second;
    out.kind = static_cast<certificate::DmsPairProof::Kind>(pair.kind);
    out.chain.assign(pair.chain.begin(), pair.chain.end());
    out.tetrahedra.assign(pair.tetrahedra.begin(), pair.tetrahedra.end());
    for (std::size_t i = 0; i < 2; ++i) out.feet[i] = to_fraction(pair.feet[i]);
    for (const DmsPoint& direction : pair.directions)
      out.directions.push_back(
          {to_fraction(direction[0]), to_fraction(direction[1]), to_fraction(direction[2])});
    return out;
  }

  // A face that is its only tile needs no list.
  void add_tiles(const std::vector<DmsTile>& tiles) {
    auto& out = body_.tiles.emplace_back();
    if (tiles.size() == 1 && tiles[0].planes.empty()) return;
    for (const DmsTile& tile : tiles) {
      auto& proof = out.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) proof.points[i] = number_of(tile.corners[i]);
      proof.planes = proofs_of(tile.planes);
    }
  }
  std::uint64_t number_of(const DmsPoint& p) {
    if (numbers_.empty())
      for (const TetrahedronFace f : complex_.boundary())
        for (const std::uint32_t v : complex_.vertices(f)) numbers_.emplace(model_.knot(v, 0), v);
    const auto [at, is_new] = numbers_.emplace(p, model_.clouds.size() + body_.points.size());
    if (is_new) {
      auto& out = body_.points.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) out[c] = to_fraction(p[c]);
    }
    return at->second;
  }
  bool has_long_points() const {
    const auto is_long = [](const certificate::Fraction& x) {
      return std::max(x.numerator.size(), x.denominator.size()) > kMaxPointBytes;
    };
    return std::any_of(body_.points.begin(), body_.points.end(),
                       [&](const auto& p) { return std::any_of(p.begin(), p.end(), is_long); });
  }

  const DmsModel& model_;
  const certificate::Subject& subject_;
  const CertifyOptions& options_;
  TetrahedralComplex complex_;
  DmsFacts facts_;
  Certified out_;
  std::vector<DmsRefutation> refutations_;  // the first one becomes the certificate
  std::uint64_t num_defects_ = 0;
  SurfaceProof domain_;
  std::vector<DmsLeafTree> trees_;
  certificate::DmsBody body_;
  std::optional<certificate::DmsPairsBody> pairs_;  // if the surface is proved by them
  std::map<DmsPoint, std::uint64_t> numbers_;       // of points of tiles
};

}  // namespace

DmsFacts dms_facts_of(const DmsModel& model) {
  DmsFacts out;
  out.tetrahedra = model.tetrahedra.size();
  out.control_points = model.num_control();
  out.degree = model.degree;
  return out;
}

Certified certify_dms(const DmsModel& model, const certificate::Subject& subject,
                      const CertifyOptions& options) {
  return DmsCertification(model, subject, options).run();
}

}  // namespace veritope
