// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/v_model_judge.h: cells as a file, what certify and the C++ checker say of it, what contradicts what is
// known about the model, and other descriptions of the same cells. For programs that link the checker's objects.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "robust/base/disjoint_sets.h"
#include "splines/bezier_calculus.h"
#include "splines/bspline_domain.h"
#include "splines/de_casteljau.h"
#include "tests/support/checker_call.h"
#include "tests/support/random_v_models.h"
#include "verify/certify/certify.h"

namespace veritope::random_v_models {

struct Judged {
  std::string file;  ///< the model, .vjson
  Certified certified;
  std::string code;  ///< of the first finding
  std::string
      problem;  ///< what is wrong in any case: a certificate that is rejected, a false witness

  Verdict verdict() const { return certified.verdict; }
  const PatchFacts& facts() const { return std::get<PatchFacts>(certified.facts); }
};

inline std::string file_of(const std::vector<VVolume>& cells) {
  SplineModel model;
  for (const VVolume& cell : cells) {
    SplineEntity entity{cell, {}, {}, {}};
    model.entities.push_back(std::move(entity));
  }
  return spline_json_bytes(model);
}

/// Whether det J has this sign at the parameter, with derivatives from one side where it is a knot: a few lines of
/// rationals that share nothing with solids/vmodel but polynomials.
inline bool has_determinant(const VVolume& cell, const Point& at, Sign sign) {
  // det of the derivatives times a positive factor, in the piece that ends (side 0) or begins there, axis by axis.
  const auto in_piece = [&](unsigned sides) -> std::optional<Sign> {
    VVolume part = cell;
    Point in;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& knots = cell.axis(a).knots;
      const bool is_right = (sides >> a & 1) != 0;
      const auto high = is_right ? std::upper_bound(knots.begin(), knots.end(), at[a])
                                 : std::lower_bound(knots.begin(), knots.end(), at[a]);
      if (high == knots.begin() || high == knots.end()) return std::nullopt;
      part = restricted(part, a, *(high - 1), *high).value();
      in[a] = (at[a] - *(high - 1)) / (*high - *(high - 1));
    }
    const auto all = part.coefficients();
    const BezierVolume<Rational> map(
        {part.axis(0).degree, part.axis(1).degree, part.axis(2).degree}, part.num_components(),
        false, {all.begin(), all.end()});
    const auto p = evaluate(map, in);
    std::array<Point, 3> d;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto dp = evaluate(derivative(map, a), in);
      for (std::size_t c = 0; c < 3; ++c)
        d[a][c] = part.is_rational() ? dp[c] * p[3] - p[c] * dp[3] : dp[c];
    }
    Rational det;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      det += d[0][k] * (d[1][i] * d[2][j] - d[1][j] * d[2][i]);
    }
    return det.sign();
  };
  for (unsigned sides = 0; sides < 8; ++sides)
    if (in_piece(sides) == sign) return true;
  return false;
}

inline Judged judged(const std::vector<VVolume>& cells, PatchOrientation orientation) {
  Judged out;
  out.file = file_of(cells);
  const ModelFile file =
      read_model_bytes({reinterpret_cast<const unsigned char*>(out.file.data()), out.file.size()},
                       "model.vjson", {})
          .value();
  CertifyOptions options;
  options.orientation = orientation;
  out.certified = certify(file, options).value();
  const Certified& c = out.certified;
  if (!c.findings.empty()) out.code = c.findings.front().code;
  if (c.verdict == Verdict::kUndecided) return out;
  const std::string answer = check_in_process(c.copy ? c.copy->bytes : out.file,
                                              {c.certificate.begin(), c.certificate.end()});
  if (answer.find("more work than allowed") != answer.npos) {  // as the program takes it
    out.certified.verdict = Verdict::kUndecided;
    return out;
  }
  if (answer.substr(0, 7) != "ACCEPT ") out.problem = "the checker says: " + answer;
  for (const Finding& f : c.findings) {
    if (!f.witness.fold) continue;
    const VVolume& cell = cells[f.place.parts.front().entity];
    for (std::size_t i = 0; i < 2; ++i) {
      const FoldPoint& point = (*f.witness.fold)[i];
      const Sign planned = i == 0 ? Sign::kPositive : Sign::kNegative;
      if (point.sign != planned || !has_determinant(cell, point.parameters, planned))
        out.problem = "a point of the fold has another sign";
    }
  }
  return out;
}

/// What contradicts the numbers that are known; empty if nothing does. The model is VALID.
/// @param are_counts_kept  whether cells are those of the known solid
inline std::string wrong_numbers(const Judged& j, const KnownSolid& truth, std::size_t num_cells,
                                 bool are_counts_kept) {
  const PatchFacts& facts = j.facts();
  if (j.certified.claim != "vmodel-1" || !facts.vmodel) return "no claim about cells";
  std::vector<std::int64_t> genus;
  for (const PatchShellFacts& s : facts.shell_facts) genus.push_back(s.genus);
  std::sort(genus.begin(), genus.end());
  if (genus != truth.genus) return "wrong genus or number of shells";
  if (facts.bodies != truth.bodies) return "wrong number of bodies";
  if (facts.vmodel->singular.empty() != truth.is_regular) return "regular, or not regular";
  const VCounts& n = facts.vmodel->counts;
  const auto chi = static_cast<std::int64_t>(truth.v_points + truth.v_surfaces) -
                   static_cast<std::int64_t>(truth.v_curves + num_cells);
  if (n.euler != chi) return "wrong Euler characteristic";
  if (are_counts_kept && (n.cells != num_cells || n.v_surfaces != truth.v_surfaces ||
                          n.v_curves != truth.v_curves || n.v_points != truth.v_points))
    return "wrong numbers of V-surfaces, V-curves or V-points";
  return "";
}

/// The integral of det J over all cells. REQUIRES polynomial ones.
inline Rational volume_of(const std::vector<VVolume>& cells) {
  Rational out;
  for (const VVolume& cell : cells) {
    const auto pieces = bezier_pieces(cell).pieces;  // the integral does not depend on the domain
    for (const auto& map : pieces)
      out += integral(dot(cross(derivative(map, 0), derivative(map, 1)), derivative(map, 2)))[0];
  }
  return out;
}

enum class Change { kAffine, kRelabelled, kElevated, kInserted, kSplit };
inline constexpr std::array<const char*, 5> kChangeNames{"affine", "relabelled", "elevated",
                                                         "knots inserted", "split"};

struct Changed {
  std::vector<VVolume> cells;
  Rational factor = Rational(1);  ///< of the volume
  bool has_left_handed = false;
};

/// Every cell that is cut is cut in the middle of an axis, and so are those that are glued to it across other axes.
inline std::vector<VVolume> split_once(const std::vector<VVolume>& cells, Random& random) {
  const VModel model = make_v_model(cells, VOrientation::kKeep).value();
  DisjointSets<std::size_t> axes(3 * cells.size());
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) {
    const VFaceRole& role = model.face(f);
    if (!role.is_glued()) continue;
    const auto own = v_face_axes(f % 6 / 2), other = v_face_axes(role.mate % 6 / 2);
    const bool is_exchanged = (role.symmetry & 1) != 0;
    for (std::size_t k = 0; k < 2; ++k)
      axes.join(3 * (f / 6) + own[k], 3 * (role.mate / 6) + other[is_exchanged ? 1 - k : k]);
  }
  const std::size_t chosen = axes.find(random.below(3 * cells.size()));
  std::vector<VVolume> out;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    std::vector<VVolume> parts{cells[c]};
    for (std::size_t a = 0; a < 3; ++a) {
      if (axes.find(3 * c + a) != chosen) continue;
      std::vector<VVolume> halves;
      for (const VVolume& part : parts) {
        const Rational low = part.axis(a).domain_begin(), high = part.axis(a).domain_end(),
                       middle = (low + high) / Rational(2);
        halves.push_back(restricted(part, a, low, middle).value());
        halves.push_back(restricted(part, a, middle, high).value());
      }
      parts = std::move(halves);
    }
    out.insert(out.end(), parts.begin(), parts.end());
  }
  return out;
}

inline Changed changed(const std::vector<VVolume>& cells, Change change, Random& random) {
  Changed out{cells, Rational(1), false};
  switch (change) {
    case Change::kAffine: {
      const AffineMap map = random_affine_map(random);
      out.cells = affine_image(cells, map);
      out.factor = determinant(map);
      out.has_left_handed = out.factor.sign() == Sign::kNegative;
      if (out.has_left_handed) out.factor = -out.factor;
      break;
    }
    case Change::kRelabelled:
      for (std::size_t n = out.cells.size(); n > 1; --n)
        std::swap(out.cells[n - 1], out.cells[random.below(n)]);
      for (VVolume& cell : out.cells) {
        const auto s = static_cast<unsigned>(random.below(48));
        cell = v_cells::turned(cell, s);
        out.has_left_handed = out.has_left_handed || v_cells::is_turn_odd(s);
      }
      break;
    case Change::kElevated:
      for (VVolume& cell : out.cells)
        if (random.below(2) == 0) cell = elevate(cell, random.below(3), 1);
      break;
    case Change::kInserted:
      for (VVolume& cell : out.cells) {
        const std::size_t a = random.below(3);
        const auto& axis = cell.axis(a);
        const Rational t = axis.domain_begin() + (axis.domain_end() - axis.domain_begin()) *
                                                     Rational(random.between(1, 6)) / Rational(7);
        if (multiplicity(axis, t) < axis.degree) cell = insert_knot(cell, a, t);
      }
      break;
    case Change::kSplit: out.cells = split_once(cells, random); break;
  }
  return out;
}

}  // namespace veritope::random_v_models
