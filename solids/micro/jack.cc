// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/jack.h"

#include <string>
#include <utility>
#include <vector>

#include "solids/micro/jack_maker_internal.h"
#include "solids/vmodel/v_model.h"

namespace veritope {
namespace {

const Rational kHalf = Rational(1) / Rational(2);

int sign_of_wall(int wall) { return wall % 2 == 0 ? -1 : 1; }
// The normal of a patch whose parameters run along the axes a and b, upward, points along a x b.
bool is_turned(std::size_t a, std::size_t b, std::size_t out, int sign) {
  const bool is_cyclic = (a + 1) % 3 == b && (b + 1) % 3 == out;
  return is_cyclic != (sign > 0);
}
bool is_inside(const Rational& x) { return Rational(0) < x && x < kHalf; }

}  // namespace

namespace internal {

JackMaker::JackMaker(const JackShape& shape) : shape_(shape) {
  const JackHalfWidth node = {shape.node, Rational(0)};
  const Rational length = kHalf - shape.node;
  for (int k = 0; k <= shape.degree; ++k)
    profile_.push_back({shape.node + length * Rational(k) / Rational(shape.degree),
                        2 * k < shape.degree ? node : cap()});
}
JackHalfWidth JackMaker::cap() const {
  return shape_.range ? JackHalfWidth{Rational(0), Rational(1)}
                      : JackHalfWidth{shape_.cap, Rational(0)};
}
void JackMaker::add_arm(int wall) {
  for (const std::size_t other : v_face_axes(static_cast<std::size_t>(wall / 2)))
    for (const int sign : {-1, 1}) add_side(wall, other, sign);
  add_square(wall, profile_.back());
}
void JackMaker::add_closed_side(int wall) { add_square(wall, profile_.front()); }
MicroTile JackMaker::take() {
  bool depends = false;
  for (const TilePatch& patch : tile_.patches) depends = depends || patch.wall.has_value();
  if (depends) tile_.range = shape_.range;
  return std::move(tile_);
}

// The corner of a cross-section of an arm.
JackPoint JackMaker::corner(int wall, const JackCrossSection& at, int first, int second) {
  JackPoint p;
  const auto axis = static_cast<std::size_t>(wall / 2);
  p.fixed[axis] = at.distance * Rational(sign_of_wall(wall));
  const auto others = v_face_axes(axis);
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational sign = k == 0 ? first : second;
    p.fixed[others[k]] = at.width.fixed * sign;
    p.slope[others[k]] = at.width.slope * sign;
  }
  return p;
}
void JackMaker::add_square(int wall, const JackCrossSection& at) {
  const auto axis = static_cast<std::size_t>(wall / 2);
  const auto others = v_face_axes(axis);
  std::vector<JackPoint> net;
  const bool turned = is_turned(others[0], others[1], axis, sign_of_wall(wall));
  for (const int i : {-1, 1})
    for (const int j : {-1, 1})
      net.push_back(turned ? corner(wall, at, j, i) : corner(wall, at, i, j));
  add(wall, {1, 1}, net);
}
// The side of an arm on which the axis `out` is greatest or least.
void JackMaker::add_side(int wall, std::size_t out, int sign) {
  const auto axis = static_cast<std::size_t>(wall / 2);
  const auto others = v_face_axes(axis);
  const std::size_t along = others[0] == out ? others[1] : others[0];
  const bool turned = is_turned(along, axis, out, sign * sign_of_wall(wall));
  std::vector<JackPoint> net;
  for (const int i : {-1, 1})
    for (const JackCrossSection& at : profile_) {
      const int width = turned ? -i : i;
      net.push_back(out == others[0] ? corner(wall, at, sign, width)
                                     : corner(wall, at, width, sign));
    }
  add(wall, {1, shape_.degree}, net);
}
void JackMaker::add(int wall, std::array<int, 2> degrees, const std::vector<JackPoint>& net) {
  TilePatch patch;
  patch.degrees = degrees;
  std::vector<TilePoint> fixed, slope;
  bool moves = false;
  for (const JackPoint& p : net) {
    fixed.push_back({p.fixed[0] + kHalf, p.fixed[1] + kHalf, p.fixed[2] + kHalf});
    slope.push_back(p.slope);
    for (const Rational& x : p.slope) moves = moves || x.sign() != Sign::kZero;
  }
  patch.points.push_back(std::move(fixed));
  if (moves) {
    patch.wall = wall;
    patch.points.push_back(std::move(slope));
  }
  tile_.patches.push_back(std::move(patch));
}

std::string fault_of_jack(const JackShape& shape, const std::string& name) {
  const auto outside = [&](const char* what, const Rational& x) {
    return std::string(what) + " = " + x.to_string() + " of a " + name +
           " is not between 0 and 1/2";
  };
  if (!is_inside(shape.node)) return outside("node", shape.node);
  if (!shape.range && !is_inside(shape.cap)) return outside("cap", shape.cap);
  if (shape.degree != 1 && shape.degree != 3)
    return "degree = " + std::to_string(shape.degree) + " of a " + name + " is neither 1 nor 3";
  if (shape.arms > 63)
    return "arms = " + std::to_string(shape.arms) + " of a " + name + " is not 0 to 63";
  if (!shape.range) return "";
  const auto [lo, hi] = *shape.range;
  if (lo > 0 && lo <= hi && 2 * hi < kMaxWallNumber) return "";
  return "the range from " + std::to_string(lo) + " to " + std::to_string(hi) + " of a " + name +
         "'s arms, in 2^-20, is not inside 0 and 1/2";
}
std::string keys_of_jack(const JackShape& s) {
  std::string keys = ",node=" + s.node.to_string();
  if (!s.range) keys += ",cap=" + s.cap.to_string();
  keys += ",degree=" + std::to_string(s.degree);
  if (s.arms != 63) keys += ",arms=" + std::to_string(s.arms);
  return keys;
}

}  // namespace internal

Result<MicroTile> jack_tile(const JackShape& shape) {
  if (const std::string fault = internal::fault_of_jack(shape, "jack"); !fault.empty())
    return bad_argument(fault);
  internal::JackMaker maker(shape);
  for (int wall = 0; wall < 6; ++wall) {
    if ((shape.arms >> wall & 1) == 0)
      maker.add_closed_side(wall);
    else
      maker.add_arm(wall);
  }
  MicroTile tile = maker.take();
  tile.name = "jack" + internal::keys_of_jack(shape);
  return tile;
}

}  // namespace veritope
