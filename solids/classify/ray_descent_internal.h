// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/ray_descent_internal.h: the pieces of patches that a ray meets, and how often their union is crossed.
// Theory: docs/THEORY.md, POINT-3. Internal to solids/classify.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solids/classify/axis_ray.h"
#include "solids/classify/ray_net_internal.h"

namespace veritope::internal {

/// How a piece lies to the line of a ray, by its closed hull.
enum class RayPlace {
  kMissesRay,       ///< the hull has no point of the closed ray
  kMissesBackward,  ///< the hull has no point of the closed opposite half-line
  kUnknown          ///< neither was shown
};

/// Where a piece lies by the signs of its coefficients, and by the plane of its mean normal through the point: a hull
/// strictly on one side of that plane misses the half-line on the other side.
template <typename Net>
RayPlace place_of(const Net& net, const AxisRay& ray) {
  const auto has_sign = [](CommonSign s) {
    return s == CommonSign::kPositive || s == CommonSign::kNegative;
  };
  if (has_sign(net.sign((ray.axis + 1) % 3)) || has_sign(net.sign((ray.axis + 2) % 3)))
    return RayPlace::kMissesRay;
  const CommonSign along = net.sign(ray.axis);
  if (has_sign(along))
    return (along == CommonSign::kPositive) == ray.is_upward ? RayPlace::kMissesBackward
                                                             : RayPlace::kMissesRay;
  const PlaneNormal n = net.normal();
  const CommonSign side = net.side(n);
  if (!has_sign(side)) return RayPlace::kUnknown;
  const double ahead = ray.is_upward ? n[ray.axis] : -n[ray.axis];
  // The ray lies in the closed half-space of `ahead`, the hull in the open one of `side`.
  const bool is_towards_hull = side == CommonSign::kPositive ? ahead > 0 : ahead < 0;
  return is_towards_hull ? RayPlace::kMissesBackward : RayPlace::kMissesRay;
}

/// A part of a line of parameters where tested pieces end; its winding is counted where they do not cancel.
template <typename Net>
struct Stretch {
  using Parameter = typename Net::Parameter;
  std::uint64_t line =
      0;  ///< twice the number of a common edge, or twice that of a patch and axis, and 1
  Parameter place{};  ///< of an inner line
  Parameter begin{}, end{};
  int sign = 0;  ///< 1: passed from begin to end
  std::uint32_t shell = 0;
  typename Net::Curve curve;  ///< from begin to end

  bool is_on_line_of(const Stretch& b) const { return line == b.line && place == b.place; }
  bool operator<(const Stretch& b) const {
    if (line != b.line) return line < b.line;
    if (place != b.place) return place < b.place;
    if (begin != b.begin) return begin < b.begin;
    return end < b.end;
  }
};

template <typename Net>
class RayDescent {
 public:
  using Parameter = typename Net::Parameter;
  struct Limits {
    int levels = 0;          ///< halvings of a patch along one axis
    std::size_t visits = 0;  ///< of pieces
    std::size_t open = 0;    ///< of open pieces of a patch; the rest of the patch is then left out
  };

  RayDescent(const AxisRay& ray, const Limits& limits) : ray_(ray), limits_(limits) {}

  /// @param known  how the whole patch lies to the line: the patch itself, not its hull
  void add_patch(std::uint32_t patch, Net net, RayPlace known = RayPlace::kUnknown) {
    first_open_ = open_.size();
    const Piece whole{
        patch, {Parameter(), Parameter()}, {Net::parameter_one(), Net::parameter_one()}, {}};
    switch (known) {
      case RayPlace::kMissesRay: return;
      case RayPlace::kMissesBackward: return add_sides(whole, net);
      case RayPlace::kUnknown: return visit(whole, std::move(net));
    }
  }

  const std::vector<OpenPiece>& open() const { return open_; }
  bool is_over_limit() const { return visits_ > limits_.visits; }

  /// The winding numbers; nothing if the numbers do not decide for this view. REQUIRES no open pieces.
  std::optional<ShellWindings> windings(const std::array<double, 2>& turn) {
    std::sort(stretches_.begin(), stretches_.end());
    ShellWindings out;
    for (std::size_t first = 0, last = 0; first < stretches_.size(); first = last) {
      while (last < stretches_.size() && stretches_[last].is_on_line_of(stretches_[first])) ++last;
      const auto part = winding_on_line(first, last, turn);
      if (!part) return std::nullopt;
      if (*part != 0) add(stretches_[first].shell, ray_.is_upward ? *part : -*part, out);
    }
    std::erase_if(out, [](const auto& w) { return w.second == 0; });
    return out;
  }

 private:
  struct Piece {
    std::uint32_t patch;
    std::array<Parameter, 2> lo, hi;
    std::array<int, 2> levels;
  };

  static void add(std::uint32_t shell, int winding, ShellWindings& out) {
    for (auto& [known, sum] : out)
      if (known == shell) {
        sum += winding;
        return;
      }
    out.emplace_back(shell, winding);
  }

  void visit(const Piece& piece, Net net) {
    if (++visits_ > limits_.visits) return;
    switch (place_of(net, ray_)) {
      case RayPlace::kMissesRay: return;
      case RayPlace::kMissesBackward: return add_sides(piece, net);
      case RayPlace::kUnknown: break;
    }
    const std::size_t axis = axis_to_halve(piece, net);
    if (piece.levels[axis] == limits_.levels || net.is_exhausted()) return add_open(piece);
    if (open_.size() - first_open_ >= limits_.open) return;
    Piece left = piece, right = piece;
    left.hi[axis] = right.lo[axis] = Net::middle(piece.lo[axis], piece.hi[axis]);
    ++left.levels[axis];
    ++right.levels[axis];
    Net upper = net.halve(axis);
    visit(left, std::move(net));
    visit(right, std::move(upper));
  }

  // A piece at a collapsed side is cut towards that side only: otherwise ever narrower pieces would end at its point.
  std::size_t axis_to_halve(const Piece& piece, const Net& net) const {
    const TensorForm& form = net.form();
    std::array<bool, 2> is_at_pole{};
    for (std::uint32_t s = 0; s < 4; ++s)
      if (form.sides[s].is_collapsed && is_at_border(piece, s))
        is_at_pole[1 - axis_of_side(s)] = true;
    if (is_at_pole[0] != is_at_pole[1]) return is_at_pole[0] ? 0 : 1;
    const double u = net.length(0), v = net.length(1);
    if (u == v) return piece.levels[0] <= piece.levels[1] ? 0 : 1;
    return u > v ? 0 : 1;
  }

  static bool is_at_border(const Piece& piece, std::uint32_t side) {
    const std::size_t across = 1 - axis_of_side(side);
    return side == 1 || side == 2 ? piece.hi[across] == Net::parameter_one()
                                  : piece.lo[across] == Parameter();
  }

  void add_open(const Piece& piece) {
    OpenPiece out{piece.patch, {}};
    for (std::size_t k = 0; k < 2; ++k)
      out.middle[k] = 0.5 * Net::to_double(piece.lo[k]) + 0.5 * Net::to_double(piece.hi[k]);
    open_.push_back(out);
  }

  void add_sides(const Piece& piece, const Net& net) {
    for (std::uint32_t s = 0; s < 4; ++s) {
      const std::size_t along = axis_of_side(s), across = 1 - along;
      Stretch<Net> out;
      out.begin = piece.lo[along];
      out.end = piece.hi[along];
      const TensorForm& form = net.form();
      out.sign = runs_upward(s) ? form.coefficient : -form.coefficient;
      out.shell = form.shell;
      bool is_reversed = false;
      if (!is_at_border(piece, s)) {
        out.line = std::uint64_t{piece.patch} << 2 | along << 1 | 1;
        out.place = s == 1 || s == 2 ? piece.hi[across] : piece.lo[across];
      } else {
        const GluedSide& side = form.sides[s];
        if (side.is_collapsed) continue;
        // Parameters of an edge run as its forward sides are travelled.
        out.line = std::uint64_t{side.edge} << 1;
        is_reversed = runs_upward(s) != side.is_forward;
        if (is_reversed) {
          std::swap(out.begin, out.end);
          out.begin = Net::parameter_one() - out.begin;
          out.end = Net::parameter_one() - out.end;
        }
        out.sign = side.is_forward ? form.coefficient : -form.coefficient;
      }
      out.curve = net.curve(s, ray_.axis, is_reversed);
      stretches_.push_back(std::move(out));
    }
  }

  std::optional<int> winding_on_line(std::size_t first, std::size_t last,
                                     const std::array<double, 2>& turn) {
    if (last - first == 2 && stretches_[first].begin == stretches_[first + 1].begin &&
        stretches_[first].end == stretches_[first + 1].end &&
        stretches_[first].sign == -stretches_[first + 1].sign)
      return 0;
    cuts_.clear();
    for (std::size_t k = first; k < last; ++k) {
      cuts_.push_back(stretches_[k].begin);
      cuts_.push_back(stretches_[k].end);
    }
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    int sum = 0;
    for (std::size_t c = 0; c + 1 < cuts_.size(); ++c) {
      int net = 0;
      const Stretch<Net>* on = nullptr;
      for (std::size_t k = first; k < last; ++k)
        if (stretches_[k].begin <= cuts_[c] && cuts_[c + 1] <= stretches_[k].end) {
          net += stretches_[k].sign;
          on = &stretches_[k];
        }
      if (net == 0) continue;
      const auto winding =
          Net::winding(on->curve, on->begin, on->end, cuts_[c], cuts_[c + 1], turn);
      if (!winding) return std::nullopt;
      sum += net * *winding;
    }
    return sum;
  }

  const AxisRay ray_;
  const Limits limits_;
  std::size_t visits_ = 0;
  std::vector<Stretch<Net>> stretches_;
  std::vector<OpenPiece> open_;
  std::size_t first_open_ = 0;  // of the patch
  std::vector<Parameter> cuts_;
};

}  // namespace veritope::internal
