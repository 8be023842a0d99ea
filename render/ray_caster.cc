// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/ray_caster_internal.h"

namespace veritope::internal {
namespace {

Box3d box_between(const Vec3d& a, const Vec3d& b) {
  Box3d box = empty_box();
  add(to_point(a), &box);
  add(to_point(b), &box);
  return box;
}

// One ray on its way through the cells that are not 0.
class RayWalk {
 public:
  RayWalk(const SolidProbe& solid, const ParametricRay& ray, double begin,
          std::optional<double> guess, bool with_thin)
      : solid_(solid), ray_(ray), begin_(begin), guess_(guess), with_thin_(with_thin) {}

  // Whether the walk ends in this piece.
  bool take(const RayPiece& piece) {
    answer_.met_cells = true;
    if (!(piece.begin <= last_)) {  // a gap, whose points are off the solid
      if (is_hit_in_passed()) return true;
      off_ = piece.begin;
      if (piece.begin <= begin_ && is_in(begin_ + kNear))
        return end_at({begin_, is_in(begin_ - kNear)});
    }
    last_ = piece.end;
    if (piece.value == Value3::kOne) return end_between(off_, piece.begin);
    return is_hit_in(piece);
  }
  // After the last piece.
  RayAnswer finish() {
    if (!answer_.hit) is_hit_in_passed();
    return answer_;
  }

 private:
  static constexpr double kStride = RayCaster::kStride;
  static constexpr double kNear = 0.5 * RayCaster::kTolerance;

  bool is_in(double t) const {
    const PointWord word = solid_.word(ray_.at(t));
    return word != PointWord::kOut;
  }
  bool end_at(const RayHit& hit) {
    answer_.hit = hit;
    return true;
  }

  bool is_hit_in(const RayPiece& piece) {
    for (double t = kStride * std::ceil(piece.begin / kStride); t <= piece.end; t += kStride) {
      if (t <= off_) continue;
      if (is_in(t)) return end_between(off_, t);
      off_ = t;
    }
    passed_ = {num_passed_ == 0 ? piece.begin : passed_.begin, piece.end, Value3::kMixed};
    ++num_passed_;
    return false;
  }

  // The point at `in` is in the solid, that at `off` is not.
  bool end_between(double off, double in) {
    // From the guess in steps that grow, until it is between them.
    if (guess_)
      for (double step = kNear; off < *guess_ - step || *guess_ + step < in; step *= 8) {
        const double t = *guess_ - step, u = *guess_ + step;
        if (off < t && t < in) (is_in(t) ? in : off) = t;
        if (off < u && u < in) (is_in(u) ? in : off) = u;
        if (t <= off && in <= u) break;
      }
    while (in - off > RayCaster::kTolerance) {
      const double middle = 0.5 * (off + in);
      if (!(off < middle && middle < in)) break;
      (is_in(middle) ? in : off) = middle;
    }
    return end_at({in, false});
  }

  // The strides through the pieces before this gap found nothing: looks for what is thinner than they are.
  bool is_hit_in_passed() {
    if (num_passed_ == 0 || !with_thin_) return false;
    num_passed_ = 0;
    if (!is_thin_hit(passed_.begin, passed_.end)) return false;
    answer_.hit->is_thin = true;
    return true;
  }
  // Boxes around shorter and shorter parts of the ray, until the middle of one is in the solid, or they are all 0.
  bool is_thin_hit(double begin, double end) {
    if (solid_.value(box_between(ray_.at(begin), ray_.at(end))) == Value3::kZero) return false;
    const double middle = 0.5 * (begin + end);
    if (end - begin <= RayCaster::kThin && is_in(middle)) {
      guess_.reset();
      return is_in(begin) ? end_at({begin, false}) : end_between(begin, middle);
    }
    if (end - begin <= RayCaster::kThinnest || !(begin < middle && middle < end))
      return solid_.has_own_walls() && end_at({begin, false});
    return is_thin_hit(begin, middle) || is_thin_hit(middle, end);
  }

  const SolidProbe& solid_;
  const ParametricRay& ray_;
  double begin_;
  std::optional<double> guess_;
  bool with_thin_;
  double last_ = -std::numeric_limits<double>::infinity();  // the end of the piece before
  double off_ = 0;   // the last parameter that is known to be off the solid
  RayPiece passed_;  // since the last gap
  unsigned num_passed_ = 0;
  RayAnswer answer_;
};

}  // namespace

RayAnswer RayCaster::first_hit(const ParametricRay& ray, std::optional<double> guess,
                               bool with_thin) const {
  RayWalk walk(solid_, ray, cells_.clipped(ray).begin, guess, with_thin);
  cells_.walk(ray, [&](const RayPiece& piece) { return walk.take(piece); });
  return walk.finish();
}

}  // namespace veritope::internal
