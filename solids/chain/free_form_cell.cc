// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/free_form_cell.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope {
namespace {

using Homogeneous = std::vector<Rational>;  // x, y, z and, of a rational patch, the weight

Patch::Curve elevated(const Patch::Curve& curve, int degree) {
  return elevate(curve, 0, degree - curve.degree(0));
}

Homogeneous coefficient(const Patch::Curve& curve, std::size_t i) {
  Homogeneous out;
  for (int c = 0; c < curve.num_components(); ++c) out.push_back(curve.component(c)[i]);
  return out;
}

PatchPoint affine(const Homogeneous& h) { return *point_of(h); }

// The chord of a side with the weights of the side: control point i lies at i / n.
Patch::Curve chord_of(const Patch::Curve& side) {
  Patch::Curve out = side;
  const int n = side.degree(0);
  const PatchPoint a = affine(coefficient(side, 0)),
                   b = affine(coefficient(side, static_cast<std::size_t>(n)));
  for (int i = 0; i <= n; ++i) {
    const Rational t = Rational(i) / Rational(n);
    const auto at = static_cast<std::size_t>(i);
    const Rational w = side.is_rational() ? side.component(3)[at] : Rational(1);
    for (std::size_t k = 0; k < 3; ++k)
      out.component(static_cast<int>(k))[at] = w * (a[k] + t * (b[k] - a[k]));
  }
  return out;
}

Patch::Curve reversed_curve(Patch::Curve curve) {
  for (int c = 0; c < curve.num_components(); ++c)
    std::reverse(curve.component(c).begin(), curve.component(c).end());
  return curve;
}

// A straight line between two homogeneous points.
Patch::Curve line_between(const Homogeneous& a, const Homogeneous& b, bool is_rational) {
  Patch::Curve out({1}, static_cast<int>(a.size()), is_rational);
  for (std::size_t c = 0; c < a.size(); ++c) {
    out.component(static_cast<int>(c))[0] = a[c];
    out.component(static_cast<int>(c))[1] = b[c];
  }
  return out;
}

// The triangle whose sides, travelled counterclockwise, are these curves of one degree; its other control points are
// means of its corners.
Patch::Triangle triangle_between(const std::array<Patch::Curve, 3>& sides) {
  const int n = sides[0].degree(0);
  Patch::Triangle out(n, sides[0].num_components(), sides[0].is_rational());
  for (int c = 0; c < out.num_components(); ++c) {
    const auto at = [&](std::size_t side, int i) {
      return sides[side].component(c)[static_cast<std::size_t>(i)];
    };
    for_each_triangle_index(n, [&](int i, int j, int k) {
      Rational& v = out.component(c)[triangle_index(j, k)];
      if (k == 0)
        v = at(0, j);
      else if (i == 0)
        v = at(1, k);
      else if (j == 0)
        v = at(2, i);
      else
        v = (Rational(i) * at(0, 0) + Rational(j) * at(1, 0) + Rational(k) * at(2, 0)) /
            Rational(n);
    });
  }
  return out;
}

Patch::Tensor strip_between(const Patch::Curve& chord, const Patch::Curve& side) {
  const int n = side.degree(0);
  Patch::Tensor out({n, 1}, side.num_components(), side.is_rational());
  for (int c = 0; c < side.num_components(); ++c)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i) {
      out.component(c)[2 * i] = chord.component(c)[i];
      out.component(c)[2 * i + 1] = side.component(c)[i];
    }
  return out;
}

bool is_point(const Patch::Curve& curve) {
  const PatchPoint first = affine(coefficient(curve, 0));
  for (std::size_t i = 1; i <= static_cast<std::size_t>(curve.degree(0)); ++i)
    if (affine(coefficient(curve, i)) != first) return false;
  return true;
}

Rational height(const BaseTriangle& base, const PatchPoint& p) {
  PatchPoint u, v, w;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = base[1][k] - base[0][k];
    v[k] = base[2][k] - base[0][k];
    w[k] = p[k] - base[0][k];
  }
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
         (u[0] * v[1] - u[1] * v[0]) * w[2];
}

class CellBuilder {
 public:
  CellBuilder(const Patch& patch, int scale, std::uint32_t first_edge, std::uint32_t shell)
      : patch_(patch), scale_(scale), first_edge_(first_edge), shell_(shell) {}

  std::vector<TensorForm> build() {
    const std::uint32_t n = patch_.num_sides();
    TensorForm own(patch_.is_triangle() ? as_tensor_product(patch_.triangle()) : patch_.tensor(),
                   scale_);
    if (patch_.is_triangle()) own.sides[3].is_collapsed = true;
    const int degree = patch_.max_degree();
    std::vector<Patch::Curve> chords;
    for (std::uint32_t s = 0; s < n; ++s) {
      const Patch::Curve side = patch_.side(s), chord = chord_of(side);
      chords.push_back(elevated(chord, degree));
      if (is_point(side)) {
        own.sides[s].is_collapsed = true;
      } else if (side == chord) {
        own.sides[s] = {false, chord_edge(s), true};
      } else {
        own.sides[s] = {false, side_edge(s), true};
        add_strip(chord, side, s);
      }
    }
    add(std::move(own), 1);
    if (n == 3) {
      add_base({chords[0], chords[1], chords[2]}, {0, 1, 2});
    } else {
      const Patch::Curve diagonal = elevated(
          line_between(coefficient(chords[0], 0), coefficient(chords[2], 0), patch_.is_rational()),
          degree);
      add_base({chords[0], chords[1], reversed_curve(diagonal)}, {0, 1, kBack});
      add_base({diagonal, chords[2], chords[3]}, {kAhead, 2, 3});
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t kAhead = 4, kBack = 5;  // the diagonal

  std::uint32_t side_edge(std::uint32_t s) const { return first_edge_ + s; }
  std::uint32_t chord_edge(std::uint32_t s) const { return first_edge_ + 4 + s; }
  GluedSide glued_chord(std::uint32_t s, const Patch::Curve& curve) const {
    if (is_point(curve)) return {true, 0, true};
    if (s == kAhead) return {false, first_edge_ + 8, true};
    if (s == kBack) return {false, first_edge_ + 8, false};
    return {false, chord_edge(s), true};
  }

  void add(TensorForm form, int coefficient) {
    form.coefficient = coefficient;
    form.shell = shell_;
    out_.push_back(std::move(form));
  }
  // The chord forward, the side backward.
  void add_strip(const Patch::Curve& chord, const Patch::Curve& side, std::uint32_t s) {
    TensorForm form(strip_between(chord, side), scale_);
    form.sides[0] = glued_chord(s, chord);
    form.sides[1].is_collapsed = form.sides[3].is_collapsed = true;
    form.sides[2] = {false, side_edge(s), false};
    add(std::move(form), 1);
  }
  void add_base(const std::array<Patch::Curve, 3>& sides,
                const std::array<std::uint32_t, 3>& numbers) {
    TensorForm form(as_tensor_product(triangle_between(sides)), scale_);
    for (std::size_t k = 0; k < 3; ++k) form.sides[k] = glued_chord(numbers[k], sides[k]);
    form.sides[3].is_collapsed = true;
    add(std::move(form), -1);
  }

  const Patch& patch_;
  const int scale_;
  const std::uint32_t first_edge_, shell_;
  std::vector<TensorForm> out_;
};

}  // namespace

std::vector<BaseTriangle> base_triangles(const Patch& patch) {
  std::vector<PatchPoint> c;
  for (std::uint32_t i = 0; i < patch.num_sides(); ++i) c.push_back(affine(patch.corner(i)));
  if (c.size() == 3) return {{c[0], c[1], c[2]}};
  return {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}};
}

CellSign cell_sign(const Patch& patch) {
  const std::vector<BaseTriangle> bases = base_triangles(patch);
  bool has_above = false, has_below = false, has_area = false;
  for (const BaseTriangle& base : bases) {
    for (std::size_t i = 0; i < patch.num_control(); ++i) {
      Homogeneous h;
      for (int c = 0; c < (patch.is_rational() ? 4 : 3); ++c) h.push_back(patch.component(c)[i]);
      const Sign s = height(base, affine(h)).sign();
      has_above = has_above || s > 0;
      has_below = has_below || s < 0;
    }
    PatchPoint beside = base[0];  // degenerate if no unit vector has a height
    for (std::size_t k = 0; k < 3; ++k) {
      beside[k] += Rational(1);
      has_area = has_area || height(base, beside).sign() != 0;
      beside[k] -= Rational(1);
    }
  }
  if ((has_above && has_below) || !has_area) return CellSign::kMixed;
  return has_above ? CellSign::kPlus : has_below ? CellSign::kMinus : CellSign::kZero;
}

std::vector<TensorForm> free_form_cell(const Patch& patch, int scale, std::uint32_t first_edge,
                                       std::uint32_t shell) {
  return CellBuilder(patch, scale, first_edge, shell).build();
}

}  // namespace veritope
