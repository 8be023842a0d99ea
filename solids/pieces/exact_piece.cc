// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/exact_piece.h"

#include <algorithm>
#include <cmath>

#include "robust/base/check.h"
#include "splines/de_casteljau_line.h"

namespace veritope {

namespace {

Integer common_multiple(const Integer& a, const Integer& b) {
  return divide_exactly(a, gcd(a, b)) * b;
}

void restrict_tensor(const PieceForest::Form& form, const PieceForest::Node& node,
                     Integer* control) {
  const FormShape& s = form.shape;
  const int u = form.root_bits[0] + node.level, v = form.root_bits[1] + node.level;
  const auto columns = static_cast<std::size_t>(s.q + 1);
  for (std::size_t j = 0; j < columns; ++j)
    internal::restrict_line(control + j, columns, s.p, node.i, node.i + 1, u);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(s.p); ++i)
    internal::restrict_line(control + i * columns, 1, s.q, node.j, node.j + 1, v);
}

// The corners' barycentric coordinates, in units of 2^-level: see PieceForest::Node.
std::array<Barycentric<Integer>, 3> corners_of(const PieceForest::Node& node) {
  const std::uint64_t whole = std::uint64_t{1} << node.level;
  const std::uint64_t first = (node.is_upside_down ? whole + 1 : whole - 1) - node.i - node.j;
  const std::array<std::uint64_t, 3> base{first, node.i, node.j};
  std::array<Barycentric<Integer>, 3> out;
  for (std::size_t e = 0; e < 3; ++e)
    for (std::size_t k = 0; k < 3; ++k)
      out[e][k] = Integer(k != e ? base[k] : node.is_upside_down ? base[k] - 1 : base[k] + 1);
  return out;
}

}  // namespace

// Coefficient r is the blossom at `from` degree - r times and at `to` r times.
void internal::restrict_line(Integer* first, std::size_t stride, int degree, std::uint64_t from,
                             std::uint64_t to, int bits) {
  const Integer whole = power_of_two(static_cast<std::uint64_t>(bits));
  const AffineBlend<Integer> at_from{whole - Integer(from), Integer(from)},
      at_to{whole - Integer(to), Integer(to)};
  std::vector<Integer> out, work;
  for (int r = 0; r <= degree; ++r) {
    work.clear();
    for (int i = 0; i <= degree; ++i) work.push_back(first[static_cast<std::size_t>(i) * stride]);
    for (int step = 0; step < degree; ++step)
      blend_forward(work.data(), 1, degree - step, step < r ? at_to : at_from);
    out.push_back(work.front());
  }
  for (int i = 0; i <= degree; ++i)
    first[static_cast<std::size_t>(i) * stride] = out[static_cast<std::size_t>(i)];
}

ExactPiece::ExactPiece(const PieceForest& forest, const PieceForest::Node& node) {
  const PieceForest::Form& form = forest.form(node.patch);
  shape_ = form.shape;
  is_rational_ = form.is_rational;
  set_control(forest, node);
  shorten();
  if (shape_.is_triangle) {
    control_ = [&] {
      const auto part = restricted(BezierTriangle<Integer>(shape_.p, 4, true, std::move(control_)),
                                   corners_of(node));
      return std::vector<Integer>(part.coefficients().begin(), part.coefficients().end());
    }();
  } else {
    for (std::size_t c = 0; c < 4; ++c)
      restrict_tensor(form, node, control_.data() + c * shape_.count());
  }
  shorten();
}

// Reads the control points of the node's whole patch.
void ExactPiece::set_control(const PieceForest& forest, const PieceForest::Node& node) {
  const Patch& patch = forest.complex().patch(node.patch);
  const std::size_t n = shape_.count();
  std::vector<Rational> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational unit = Rational::power_of_two(forest.frame().scale[k]);
    const Rational& shift = forest.frame().shift[k];
    for (std::size_t i = 0; i < n; ++i) {
      const Rational& x = patch.component(static_cast<int>(k))[i];
      exact.push_back(unit * (is_rational_ ? x - shift * patch.component(3)[i] : x - shift));
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    exact.push_back(is_rational_ ? patch.component(3)[i] : Rational(1));
  Integer denominator(1);
  for (const Rational& x : exact) denominator = common_multiple(denominator, x.denominator());
  for (const Rational& x : exact)
    control_.push_back(x.numerator() * divide_exactly(denominator, x.denominator()));
}

// Divides all numbers by their common factor.
void ExactPiece::shorten() {
  Integer common;
  for (const Integer& x : control_) common = gcd(common, x);
  if (common <= Integer(1)) return;
  for (Integer& x : control_) x = divide_exactly(x, common);
}

std::array<const Integer*, 4> ExactPiece::control(std::size_t i) const {
  const std::size_t n = shape_.count();
  return {&control_[i], &control_[n + i], &control_[2 * n + i], &control_[3 * n + i]};
}

Box3d ExactPiece::hull() const {
  Box3d out;
  for (std::size_t i = 0; i < shape_.count(); ++i) {
    const auto p = control(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational x(*p[k], *p[3]);
      const double lo = round_down(x), hi = round_up(x);
      out.lo[k] = i == 0 ? lo : std::min(out.lo[k], lo);
      out.hi[k] = i == 0 ? hi : std::max(out.hi[k], hi);
    }
  }
  return out;
}

void ExactPiece::make_determinants() {
  if (has_determinants()) return;
  auto forms = scaled_determinant_form<Integer>(shape_, is_rational_, control_.data());
  const std::size_t n = determinant_shape(shape_).count();
  for (std::size_t k = 0; k < 4; ++k) {
    determinants_[k].resize(n);
    forms[k].visit(
        [&](int a, int b, std::size_t i) { determinants_[k][i] = std::move(forms[k].at(a, b)); });
  }
}

// g_c of the piece as stored, times a power of two. The stored points of a polynomial piece are S times the unit w;
// their n·(S - c) is therefore evaluated at w c.
ExactPiece::Side::Side(const ExactPiece& piece, const Point3d& c) : piece_(piece) {
  std::array<Rational, 3> exact;
  Integer denominator(1);  // a power of two
  for (std::size_t k = 0; k < 3; ++k) {
    exact[k] = Rational::from_double(c[k]);
    if (!piece.is_rational_) exact[k] *= Rational(*piece.control(0)[3]);
    denominator = std::max(denominator, exact[k].denominator());
  }
  shift_ = denominator.bit_length() - 1;
  for (std::size_t k = 0; k < 3; ++k)
    c_[k] = exact[k].numerator() * divide_exactly(denominator, exact[k].denominator());
}

Integer ExactPiece::Side::value(std::size_t i) const {
  Integer g = piece_.determinants_[0][i];
  g.shift_left(shift_);
  for (std::size_t k = 0; k < 3; ++k) g.add_product(c_[k], piece_.determinants_[k + 1][i]);
  return g;
}

std::array<double, 4> ExactPiece::approx_half_space(std::size_t i, const Point3d& m) const {
  const Integer unit = is_rational_ ? Integer(1) : *control(0)[3];
  std::array<Integer, 3> a;
  std::int64_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = unit * determinants_[k + 1][i];
    bits = std::max(bits, static_cast<std::int64_t>(a[k].bit_length()));
  }
  if (bits == 0) return {};
  const Side side(*this, m);
  const auto scaled = [](const Integer& v, std::int64_t by) {
    return nearest_double(Rational(v) * Rational::power_of_two(-by));
  };
  return {scaled(a[0], bits), scaled(a[1], bits), scaled(a[2], bits),
          scaled(side.value(i), bits + static_cast<std::int64_t>(side.shift()))};
}

}  // namespace veritope
