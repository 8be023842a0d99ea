// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/rejoin.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "io/splines/patch_model.h"
#include "solids/patches/side_overlaps.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

constexpr int kMostRounds = 256;

struct CutTriangle {
  ExactTriangle first, second;
};
// Cut from the corner opposite to the side at the point t of the side.
CutTriangle cut(const ExactTriangle& triangle, std::uint32_t side, const Rational& t) {
  std::array<Barycentric<Rational>, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) corners[i][i] = Rational(1);
  const std::size_t begin = side, end = (side + 1) % 3;
  Barycentric<Rational> middle{};
  middle[begin] = Rational(1) - t, middle[end] = t;
  auto first = corners, second = corners;
  first[end] = middle, second[begin] = middle;
  return {restricted(triangle, first), restricted(triangle, second)};
}

class Rejoining {
 public:
  Rejoining(const SplineModel& model, const std::function<bool(const SplineEntity&)>& can_hold)
      : can_hold_(can_hold) {
    out_.model = model;
    for (std::uint64_t e = 0; e < model.entities.size(); ++e) number_.push_back(e);
  }

  Result<Rejoined> run() {
    for (int round = 0; round < kMostRounds; ++round) {
      Result<bool> joined = join_once();
      if (!joined) return joined.error();
      if (!*joined) return std::move(out_);
    }
    out_.left.push_back("more places than " + std::to_string(kMostRounds) +
                        " rounds could join: each insertion makes another one necessary");
    return std::move(out_);
  }

 private:
  // Whether something was joined.
  Result<bool> join_once() {
    Result<PatchSource> source = patch_source(out_.model);
    if (!source) return source.error();
    if (!source->foreign.empty())
      return Error{Code::kBadArgument, source->foreign.front().place,
                   "sides of surfaces and triangles in space are joined; this model has " +
                       to_string(source->foreign.front())};
    if (source->patches.empty()) return false;
    entities_ = std::move(source->entities);
    Result<PatchComplex> complex = make_patch_complex(std::move(source->patches));
    if (!complex) return complex.error();
    const SideOverlaps overlaps = find_side_overlaps(*complex);
    out_.left = refused_text_;
    put_left(*complex, overlaps);
    cut_now_.clear();
    bool joined = false;
    for (const TJunction& t : t_junctions_of(*complex, overlaps.found))
      joined = join(*complex, t) || joined;
    return joined;
  }

  std::size_t entity_of(std::uint32_t patch) const {
    const auto next =
        std::upper_bound(entities_.begin(), entities_.end(), std::size_t{patch},
                         [](std::size_t p, const PatchEntity& e) { return p < e.first_patch; });
    return static_cast<std::size_t>(next - entities_.begin()) - 1;
  }

  bool join(const PatchComplex& complex, const TJunction& t) {
    const std::size_t e = entity_of(t.side.patch);
    if (cut_now_.count(e) != 0) return false;  // the next round looks at its parts
    Joint joint{number_[e], number_[entity_of(t.neighbour.patch)], parameters_of(complex, e, t)};
    if (refused_.count({e, joint.at}) != 0) return false;
    const bool is_done = complex.patch(t.side.patch).is_triangle() ? cut_triangle(e, t)
                                                                   : insert_knot_at(e, t, joint);
    if (!is_done) return refuse(e, joint);
    out_.joined.push_back(std::move(joint));
    return true;
  }
  bool refuse(std::size_t e, const Joint& joint) {
    refused_.insert({e, joint.at});
    std::string at;
    for (const Rational& p : joint.at) at += (at.empty() ? "" : ", ") + p.to_string();
    refused_text_.push_back("entity " + std::to_string(joint.entity) + " at (" + at +
                            "), a corner of entity " + std::to_string(joint.neighbour) +
                            ": the numbers that the cut needs cannot be written exactly");
    out_.left.push_back(refused_text_.back());
    return false;
  }

  // The place in the entity, exactly.
  std::vector<Rational> parameters_of(const PatchComplex& complex, std::size_t e,
                                      const TJunction& t) const {
    const std::uint32_t side = t.side.side;
    if (complex.patch(t.side.patch).is_triangle()) {
      std::vector<Rational> out(3);
      out[side] = Rational(1) - t.at, out[(side + 1) % 3] = t.at;
      return out;
    }
    const Rational along = side < 2 ? t.at : Rational(1) - t.at;
    const Rational across = side == 0 || side == 3 ? Rational(0) : Rational(1);
    const auto& breaks = entities_[e].breaks;
    const std::size_t piece = t.side.patch - entities_[e].first_patch;
    const std::size_t columns = breaks[1].size() - 1;
    const std::array<std::size_t, 2> at{piece / columns, piece % columns};
    std::vector<Rational> out;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational &lo = breaks[axis][at[axis]], &hi = breaks[axis][at[axis] + 1];
      out.push_back(lo + (hi - lo) * (axis == side % 2 ? along : across));
    }
    return out;
  }

  bool insert_knot_at(std::size_t e, const TJunction& t, const Joint& joint) {
    const std::size_t axis = t.side.side % 2;
    SplineEntity entity = out_.model.entities[e];
    auto& surface = std::get<ExactSurface>(entity.shape);
    // Another corner at the other end of this line may have led to the same knot in this round.
    if (multiplicity(surface.axis(axis), joint.at[axis]) > 0) return true;
    surface = insert_knot(surface, axis, joint.at[axis]);
    if (!can_hold_(entity)) return false;
    out_.model.entities[e] = std::move(entity);
    return true;
  }

  bool cut_triangle(std::size_t e, const TJunction& t) {
    SplineEntity first = out_.model.entities[e], second = first;
    CutTriangle parts = cut(std::get<ExactTriangle>(first.shape), t.side.side, t.at);
    first.shape = std::move(parts.first), second.shape = std::move(parts.second);
    if (!can_hold_(first) || !can_hold_(second)) return false;
    out_.model.entities[e] = std::move(first);
    out_.model.entities.push_back(std::move(second));
    number_.push_back(number_[e]);
    cut_now_.insert(e);
    return true;
  }

  void put_left(const PatchComplex& complex, const SideOverlaps& overlaps) {
    const auto text = [&](const std::array<PatchSide, 2>& sides) {
      std::string out;
      for (const PatchSide s : sides)
        out += (out.empty() ? "side " : " and side ") + std::to_string(s.side) + " of entity " +
               std::to_string(number_[entity_of(s.patch)]) +
               (complex.patch(s.patch).is_triangle() ? " (a triangle)" : "");
      return out;
    };
    for (const SideOverlap& o : overlaps.found)
      if (o.agreement != CurveAgreement::kAffine)
        out_.left.push_back(text(o.sides) +
                            ": one curve in parametrizations that no affine change makes equal");
    for (const auto& sides : overlaps.undecided)
      out_.left.push_back(text(sides) + ": they meet at a parameter without a short exact form");
    if (!overlaps.is_complete)
      out_.left.push_back("open sides that were not compared, since there are too many pairs");
  }

  const std::function<bool(const SplineEntity&)>& can_hold_;
  Rejoined out_;
  std::vector<std::uint64_t> number_;  // in the model that was given
  std::vector<PatchEntity> entities_;  // of this round
  std::set<std::size_t> cut_now_;      // triangles that were cut in this round
  std::set<std::pair<std::size_t, std::vector<Rational>>> refused_;
  std::vector<std::string> refused_text_;
};

}  // namespace

Result<Rejoined> rejoined(const SplineModel& model,
                          const std::function<bool(const SplineEntity&)>& can_hold) {
  return Rejoining(model, can_hold).run();
}

}  // namespace veritope
