// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/volume_faces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/entity_error.h"
#include "robust/common_bits.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_sources.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_domain.h"
#include "splines/bspline_components.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Piece = BezierVolume<Rational>;
using Pieces = BezierPieces<Rational, 3>;

// Exact signs are computed where the numbers, brought to integers, have at most this many bits.
constexpr std::uint64_t kMostBitsOfSign = 1 << 16;

// The derivative at the middle, times the squared weight there.
template <Ring R>
std::array<R, 3> direction(const Bezier<R, 3>& piece, std::size_t axis) {
  std::array<R, 3> middle;
  middle.fill(RingNumbers<R>::ratio(1, 2));
  if (!piece.is_rational()) {
    const auto d = evaluate(derivative(piece, axis), middle);
    return {d[0], d[1], d[2]};
  }
  const auto points = numerators(piece), weights = weight(piece);
  const auto p = evaluate(points, middle), dp = evaluate(derivative(points, axis), middle);
  const R w = evaluate(weights, middle)[0];
  const R dw = evaluate(derivative(weights, axis), middle)[0];
  std::array<R, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = w * dp[k] - dw * p[k];
  return out;
}

// The Jacobian determinant at the middle, times a positive factor.
template <Ring R>
R determinant_at_middle(const Bezier<R, 3>& piece) {
  const auto a = direction(piece, 0), b = direction(piece, 1), c = direction(piece, 2);
  R det = R();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    internal::accumulate(det, a[k] * (b[i] * c[j] - b[j] * c[i]));
  }
  return det;
}

Bezier<Interval, 3> enclosed(const Piece& piece) {
  std::vector<Interval> values;
  for (const Rational& x : piece.coefficients()) values.push_back(enclose(x));
  return {piece.degrees(), piece.num_components(), piece.is_rational(), std::move(values)};
}

// The sign of the Jacobian determinant at the middle; uncertain where numbers are too long for an exact answer.
Sign3 handedness(const Piece& piece) {
  {
    const ScopedUpward upward;
    const Sign3 sign = determinant_at_middle(enclosed(piece)).sign();
    if (is_certain(sign)) return sign;
  }
  CommonBits bits(kMostBitsOfSign);
  for (const Rational& x : piece.coefficients()) bits.add(x);
  return bits.is_beyond() ? Sign3::kUncertain : to_sign3(determinant_at_middle(piece).sign());
}

// If the first piece with a sign other than 0 is left-handed, mirrors all pieces and returns true. Nothing if that
// sign is uncertain.
std::optional<bool> mirror_left_handed(std::vector<Piece>& pieces) {
  Sign3 hand = Sign3::kZero;
  for (std::size_t i = 0; i < pieces.size() && hand == Sign3::kZero; ++i)
    hand = handedness(pieces[i]);
  if (hand == Sign3::kUncertain) return std::nullopt;
  if (hand != Sign3::kNegative) return false;
  for (Piece& piece : pieces) piece = swapped(piece, 0, 1);
  return true;
}

// Where the pieces of a volume lie on it.
class Cells {
 public:
  Cells(std::uint64_t volume, bool is_mirrored, const Pieces& pieces)
      : volume_(volume), is_mirrored_(is_mirrored), grid_(pieces.grid()), breaks_(pieces.breaks) {}

  // The axes of faces_of, which are those of the mirrored piece. REQUIRES one of the volume's pieces.
  VolumeFace face(std::size_t piece, std::size_t axis, std::size_t end) const {
    const auto cell = grid_.index_of(piece);
    const auto of_volume = [&](std::size_t a) { return is_mirrored_ && a < 2 ? 1 - a : a; };
    const auto along = [&](std::size_t a) {
      return std::array{breaks_[a][cell[a]], breaks_[a][cell[a] + 1]};
    };
    std::array<std::size_t, 2> others = {axis == 0 ? 1u : 0u, axis == 2 ? 1u : 2u};
    if ((axis == 1) == (end == 1)) std::swap(others[0], others[1]);
    VolumeFace out{volume_, of_volume(axis), end, {of_volume(others[0]), of_volume(others[1])}, {},
                   {}};
    out.at = along(out.axis)[end];
    out.piece = {along(out.axes[0]), along(out.axes[1])};
    return out;
  }

 private:
  std::uint64_t volume_;
  bool is_mirrored_;
  Grid<3> grid_;
  std::array<std::vector<Rational>, 3> breaks_;
};

// Whether the patch is one point, or a curve: along an axis all lines of control points are equal
// up to a factor.
bool is_without_area(const Patch& patch) {
  const Patch::Tensor net = to_rational(patch.tensor());
  const auto count = net.grid().count();
  const std::size_t columns = static_cast<std::size_t>(net.degree(1)) + 1;
  const auto w = net.component(3);
  bool is_point = true, is_constant_in_u = true, is_constant_in_v = true;
  for (int c = 0; c < 4; ++c) {
    const auto x = net.component(c);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t first_row = i % columns, first_column = i - first_row;
      is_point = is_point && x[i] * w[0] == x[0] * w[i];
      is_constant_in_u = is_constant_in_u && x[i] * w[0] == x[first_row] * w[first_column];
      is_constant_in_v = is_constant_in_v && x[i] * w[0] == x[first_column] * w[first_row];
    }
  }
  return is_point || is_constant_in_u || is_constant_in_v;
}

// Number 6 piece + 2 axis + end, as faces_of gives them.
VolumeFace place_of(std::uint64_t number, const std::vector<std::pair<std::size_t, Cells>>& cells) {
  const std::size_t piece = number / 6;
  const auto next = std::upper_bound(
      cells.begin(), cells.end(), piece,
      [](std::size_t p, const std::pair<std::size_t, Cells>& c) { return p < c.first; });
  const auto& [first, of] = *std::prev(next);
  return of.face(piece - first, number % 6 / 2, number % 2);
}

// Equal faces with opposite normals are left out in pairs, whether two pieces share them or a flat one is folded onto
// itself there.
std::string nothing_left(std::size_t num_faces, std::uint64_t num_flat) {
  const std::string faces = std::to_string(num_faces) + " faces";
  const std::string pairs =
      " are equal in pairs, as walls between volumes and the two sides of a flat volume are";
  if (num_flat == num_faces) return "no face is left: none of the " + faces + " has an area";
  if (num_flat == 0) return "no face is left: all " + faces + pairs;
  return "no face is left: of " + faces + ", " + std::to_string(num_flat) +
         " have no area, and the others" + pairs;
}

}  // namespace

Result<VolumeFaces> volume_faces(const SplineModel& model) {
  VolumeFaces out;
  std::vector<Piece> all;
  std::vector<std::pair<std::size_t, Cells>> cells;  // with the number of the volume's first piece
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    const auto* const volume = std::get_if<ExactVolume>(&model.entities[e].shape);
    if (volume == nullptr) {
      ++out.num_others;
      continue;
    }
    ++out.num_volumes;
    if (volume->dimension() < 3)
      return error_at_entity(
          Code::kBadArgument, e,
          "a volume with " + std::to_string(volume->dimension()) + " coordinates, not in space");
    if (volume->dimension() > 3) out.with_attributes.push_back(e);
    // There are at most as many pieces as control points.
    if (volume->grid().count() > kMaxPatches / 6 - all.size())
      return error_at_entity(
          Code::kOverLimit, e,
          "the volumes up to this one may have over " + std::to_string(kMaxPatches) + " faces");
    Pieces cut = bezier_pieces(first_coordinates(*volume, 3));
    const std::optional<bool> is_mirrored = mirror_left_handed(cut.pieces);
    if (!is_mirrored)
      return error_at_entity(Code::kOverLimit, e,
                             "the volume's numbers have over " + std::to_string(kMostBitsOfSign) +
                                 " bits over a common denominator, and rounded ones do not show "
                                 "which side of its faces is outside");
    if (*is_mirrored) out.mirrored.push_back(e);
    cells.emplace_back(all.size(), Cells(e, *is_mirrored, cut));
    std::move(cut.pieces.begin(), cut.pieces.end(), std::back_inserter(all));
  }
  if (out.num_volumes == 0) return Error{Code::kEmpty, {}, "there is no volume in the model"};
  Result<std::vector<Patch>> faces = faces_of(all);
  if (!faces) return faces.error();
  for (Patch& face : *faces) {
    if (is_without_area(face)) {
      ++out.num_flat;
      continue;
    }
    out.places.push_back(place_of(face.origin().number, cells));
    out.patches.push_back(std::move(face));
  }
  if (out.patches.empty())
    return Error{Code::kEmpty, {}, nothing_left(6 * all.size(), out.num_flat)};
  return out;
}

}  // namespace veritope
