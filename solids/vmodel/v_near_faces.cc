// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_near_faces_internal.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "robust/base/entity_error.h"
#include "solids/vmodel/control_gap_internal.h"
#include "solids/vmodel/unit_space_internal.h"
#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_face_internal.h"
#include "solids/vmodel/v_face_parts_internal.h"

namespace veritope::internal {
namespace {

using Point3 = std::array<Rational, 3>;
using FaceCorners = std::array<Point3, 4>;  // corner x + 2 y

// The means of the corners of two near faces differ by at most eps in a coordinate: they lie in one box of a lattice of
// that width or in two that touch.
class NearFaceFinder {
 public:
  NearFaceFinder(const VModel& model, const Rational& eps) : model_(model), eps_(eps) {}

  Result<NearFaces> find() {
    for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
      num_open_ += model_.face(f).is_border() ? 1 : 0;
    for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
      if (!model_.face(f).is_collapsed()) boxes_.emplace_back(hash_of(box_of(corners_of(f))), f);
    std::sort(boxes_.begin(), boxes_.end());
    for (VFaceNumber f = 0; f < model_.num_faces(); ++f)
      if (model_.face(f).is_border())
        if (auto error = find_near(f)) return std::move(*error);
    NearFaces out;
    for (NearPair& pair : near_) {
      if (model_.face(pair.g).is_glued()) {
        apart_.push_back({pair.f, pair.g, VApartReason::kGlued, std::move(pair.distance)});
      } else if (num_near_[pair.f] > 1 || num_near_[pair.g] > 1) {
        apart_.push_back({pair.f, pair.g, VApartReason::kSeveral, std::move(pair.distance)});
      } else {
        out.pairs.push_back(std::move(pair));
      }
    }
    out.apart = std::move(apart_);
    return out;
  }

 private:
  using LatticeBox = std::array<Integer, 3>;

  FaceView view(VFaceNumber f) const { return {model_.cell(f / 6), f % 6}; }
  FaceCorners corners_of(VFaceNumber f) const {
    const FaceView face = view(f);
    return {corner_of(face, 0, 0), corner_of(face, 1, 0), corner_of(face, 0, 1),
            corner_of(face, 1, 1)};
  }
  LatticeBox box_of(const FaceCorners& corners) const {
    LatticeBox out;
    const Rational width = eps_ * Rational(4);
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational place =
          (corners[0][c] + corners[1][c] + corners[2][c] + corners[3][c]) / width;
      out[c] = floor_divide(place.numerator(), place.denominator());
    }
    return out;
  }
  static std::uint64_t hash_of(const LatticeBox& box) {
    return point_hash({Rational(box[0]), Rational(box[1]), Rational(box[2])});
  }

  std::optional<Error> find_near(VFaceNumber f) {
    const FaceCorners corners = corners_of(f);
    const LatticeBox box = box_of(corners);
    std::vector<VFaceNumber> found;
    for (int n = 0; n < 27; ++n) {
      const LatticeBox at{box[0] + Integer(n % 3 - 1), box[1] + Integer(n / 3 % 3 - 1),
                          box[2] + Integer(n / 9 - 1)};
      const std::uint64_t key = hash_of(at);
      for (auto i = std::lower_bound(boxes_.begin(), boxes_.end(),
                                     std::pair<std::uint64_t, VFaceNumber>(key, 0));
           i != boxes_.end() && i->first == key; ++i)
        if (i->second > f || (i->second < f && model_.face(i->second).is_glued()))
          found.push_back(i->second);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    num_candidates_ += found.size();
    if (const std::uint64_t most = kMaxWeldCandidates + 4 * num_open_; num_candidates_ > most)
      return error_at_entity(Code::kOverLimit, f / 6,
                             "the distance is too large for the model: more than " +
                                 std::to_string(most) + " pairs of faces may be within it");
    for (const VFaceNumber g : found)
      if (auto error = compare(f, corners, g)) return error;
    return std::nullopt;
  }

  unsigned symmetries_of_corners(VFaceNumber f, const FaceCorners& own, VFaceNumber g) const {
    const auto hand = [&](VFaceNumber face) {
      return hand_of_face(face, model_.is_reversed(face / 6));
    };
    const FaceCorners others = corners_of(g);
    unsigned out = gluing_symmetries(hand(f), hand(g));
    for (unsigned s = 0; s < 8; ++s)
      for (unsigned n = 0; n < 4 && (out >> s & 1) != 0; ++n) {
        const auto to = v_symmetry_image(s, {n & 1, n >> 1});
        if (point_gap(own[n], others[to[0] + 2 * to[1]]) > eps_) out &= ~(1u << s);
      }
    return out;
  }

  std::optional<Error> compare(VFaceNumber f, const FaceCorners& corners, VFaceNumber g) {
    if (is_crowded(f) && is_crowded(g)) return std::nullopt;  // one more pair would not matter
    const unsigned symmetries = symmetries_of_corners(f, corners, g);
    if (symmetries == 0) return std::nullopt;
    const FaceView face = view(f), other = view(g);
    std::optional<NearPair> nearest;
    for (unsigned s = 0; s < 8; ++s) {
      if ((symmetries >> s & 1) == 0) continue;
      if (is_too_large(face, other, s))
        return error_at_entity(Code::kOverLimit, f / 6,
                               "a face has more than " + std::to_string(kMaxWeldControlPoints) +
                                   " control points in the common space of a near one");
      const auto common = in_common_space(face, other, s);
      auto distance = control_gap(common.first, common.second);
      if (distance && (!nearest || *distance < nearest->distance))
        nearest = NearPair{f, g, static_cast<std::uint8_t>(s), std::move(*distance)};
    }
    if (nearest && nearest->distance <= eps_) {
      ++num_near_[f], ++num_near_[g];
      near_.push_back(std::move(*nearest));
    } else if (model_.face(g).is_border()) {
      if (nearest) {
        apart_.push_back({f, g, VApartReason::kControlPoints, std::move(nearest->distance)});
      } else {
        apart_.push_back({f, g, VApartReason::kWeights, std::nullopt});
      }
    }
    return std::nullopt;
  }

  bool is_crowded(VFaceNumber f) const {
    const auto at = num_near_.find(f);
    return at != num_near_.end() && at->second > 1;
  }
  static bool is_too_large(const FaceView& f, const FaceView& g, unsigned s) {
    std::size_t count = 1;
    for (std::size_t k = 0; k < 2; ++k) {
      UnitSpace own = unit_space(f.knots((s & 1) != 0 ? 1 - k : k));
      if ((s >> (k + 1) & 1) != 0) own = reversed_space(std::move(own));
      count *= common_space(own, unit_space(g.knots(k))).num_control();
    }
    return count > kMaxWeldControlPoints;
  }

  const VModel& model_;
  const Rational& eps_;
  std::vector<std::pair<std::uint64_t, VFaceNumber>> boxes_;  // hashes of boxes
  std::vector<NearPair> near_;                                // g may be glued
  std::unordered_map<VFaceNumber, std::uint32_t> num_near_;
  std::vector<VApartPair> apart_;
  std::uint64_t num_candidates_ = 0, num_open_ = 0;
};

}  // namespace

Result<NearFaces> near_faces(const VModel& model, const Rational& eps) {
  return NearFaceFinder(model, eps).find();
}

}  // namespace veritope::internal
