// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_sign.cc: the determinants N, and V2 of docs/certificates/vmodel.md.
#include "../patches/star_ring.h"
#include "vmodel.h"

namespace {
// A polynomial: Bernstein coefficients times binomials, `width` limbs each, axis 2 fastest.
struct Tri {
  size_t n[3];
  int width;
  std::vector<uint64_t> d;
  Tri(const size_t* sizes, int w) : width(w) {
    std::copy(sizes, sizes + 3, n);
    d.resize(n[0] * n[1] * n[2] * size_t(w));
  }
  uint64_t* at(size_t i, size_t j, size_t k) {
    return &d[((i * n[1] + j) * n[2] + k) * size_t(width)];
  }
};
int64_t binomial(size_t n, size_t k) {  // n <= 60
  int64_t r = 1;
  for (size_t i = 0; i < k; ++i) r = r * int64_t(n - i) / int64_t(i + 1);
  return r;
}
// The limbs that hold all coefficients of a polynomial with their sign.
int few_of(const Tri& a) {
  int few = 1;
  for (size_t i = 0; i < a.d.size(); i += size_t(a.width)) {
    const uint64_t* const x = &a.d[i];
    int used = a.width;
    while (used > 1 && x[used - 1] == (x[used - 2] >> 63 != 0 ? ~uint64_t(0) : 0)) --used;
    few = std::max(few, used);
  }
  return few;
}
template <int N>
void add_product(const Tri& a, const Tri& b, Tri* to) {
  const Ring<N> ring = {a.width};
  const int few = few_of(a);
  const uint64_t* x = a.d.data();
  const size_t w = size_t(a.width), row = b.n[2] * w;
  for (size_t i = 0; i < a.n[0]; ++i)
    for (size_t j = 0; j < a.n[1]; ++j)
      for (size_t k = 0; k < a.n[2]; ++k, x += w) {
        const uint64_t* y = b.d.data();
        for (size_t p = 0; p < b.n[0]; ++p)
          for (size_t q = 0; q < b.n[1]; ++q, y += row)
            ring.add_products(to->at(i + p, j + q, k), x, y, int(b.n[2]), few);
      }
}
void add_any_product(const Tri& a, const Tri& b, Tri* to) {
  switch (a.width) {
    case 1: return add_product<1>(a, b, to);
    case 2: return add_product<2>(a, b, to);
    case 3: return add_product<3>(a, b, to);
    case 4: return add_product<4>(a, b, to);
    case 5: return add_product<5>(a, b, to);
    case 6: return add_product<6>(a, b, to);
    case 7: return add_product<7>(a, b, to);
    default: return add_product<0>(a, b, to);
  }
}
Tri negative(Tri a) {
  for (size_t i = 0; i < a.d.size(); i += size_t(a.width)) {
    unsigned char carry = 1;
    for (size_t k = i; k < i + size_t(a.width); ++k) a.d[k] = sum_with_carry(~a.d[k], 0, &carry);
  }
  return a;
}
Tri widened(const Tri& a, int width) {
  Tri r(a.n, width);
  for (size_t i = 0, to = 0; i < a.d.size(); i += size_t(a.width), to += size_t(width)) {
    std::copy(&a.d[i], &a.d[i] + a.width, &r.d[to]);
    std::fill(&r.d[to] + a.width, &r.d[to] + width, 0 - (a.d[i + size_t(a.width) - 1] >> 63));
  }
  return r;
}
// a b - c d.
Tri minor(const Tri& a, const Tri& b, const Tri& c, const Tri& d) {
  size_t n[3];
  for (size_t k = 0; k < 3; ++k) n[k] = a.n[k] + b.n[k] - 1;
  Tri r(n, a.width);
  add_any_product(c, d, &r);
  r = negative(std::move(r));
  add_any_product(a, b, &r);
  return r;
}

class Determinant {
 public:
  explicit Determinant(const VPiece& piece) : piece_(piece) {
    const int factors = piece.is_rational ? 4 : 3;
    for (size_t k = 0; k < 3; ++k) n_[k] = size_t(factors) * (piece.n[k] - 1);
    width_ = width_of(factors);
    Tri sum(n_, width_);
    if (piece.is_rational)
      add_rational(&sum);
    else
      sum = cofactor(rows_of(3), 0, 1, 2);
    for (size_t i = 0; i < sum.d.size(); i += size_t(width_))
      coefficients_.push_back(Big::of(&sum.d[i], width_));
  }
  std::vector<Big> take() { return std::move(coefficients_); }  // times their binomials

 private:
  typedef std::vector<Tri> Row;
  // Coefficients of derivatives and binomials: below 2^(bits + 1 + degrees), as is their sum; 6 or 24 products.
  int width_of(int factors) const {
    return int((factors * (piece_.bits + 1 + int64_t(piece_.degrees())) + 6) / 64 + 1);
  }
  // The derivatives along the three axes, for determinants of so many factors.
  std::vector<Row> rows_of(int factors) const {
    std::vector<Row> rows(3);
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < (piece_.is_rational ? 4 : 3); ++c)
        rows[size_t(axis)].push_back(component(size_t(c), axis, width_of(factors)));
    return rows;
  }
  // The determinant of three columns of three rows.
  static Tri cofactor(const std::vector<Row>& rows, size_t i, size_t j, size_t k) {
    const size_t columns[5] = {i, j, k, i, j};
    size_t n[3];
    for (size_t a = 0; a < 3; ++a) n[a] = rows[0][i].n[a] + rows[1][i].n[a] + rows[2][i].n[a] - 2;
    Tri sum(n, rows[0][i].width);
    for (const size_t* c = columns; c < columns + 3; ++c)
      add_any_product(rows[0][c[0]],
                      minor(rows[1][c[1]], rows[2][c[2]], rows[1][c[2]], rows[2][c[1]]), &sum);
    return sum;
  }
  // By the cofactors of (X, Y, Z, W), which have three factors each.
  void add_rational(Tri* sum) const {
    static const size_t kOthers[4][3] = {{2, 1, 3}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}};
    const std::vector<Row> rows = rows_of(3);
    size_t c = 0;
    for (const size_t* k : kOthers)
      add_any_product(component(c++, -1, width_), widened(cofactor(rows, k[0], k[1], k[2]), width_), sum);
  }
  // (X, Y, Z, W)[c], or its derivative along an axis divided by the degree.
  Tri component(size_t c, int axis, int width) const {
    size_t n[3], step[3] = {0, 0, 0};
    for (size_t k = 0; k < 3; ++k) n[k] = piece_.n[k] - (int(k) == axis);
    if (axis >= 0) step[axis] = 1;
    Tri r(n, width);
    for (size_t i = 0; i < n[0]; ++i)
      for (size_t j = 0; j < n[1]; ++j)
        for (size_t k = 0; k < n[2]; ++k) {
          Big x = piece_.net[piece_.at(i + step[0], j + step[1], k + step[2]) + c];
          if (axis >= 0) x = x - piece_.net[piece_.at(i, j, k) + c];
          const Big factor =
              Big(binomial(n[0] - 1, i)) * Big(binomial(n[1] - 1, j)) * Big(binomial(n[2] - 1, k));
          (x * factor).store(r.at(i, j, k), width);
        }
    return r;
  }

  const VPiece& piece_;
  int width_;
  size_t n_[3];
  std::vector<Big> coefficients_;
};

struct Digits {
  int d[3];
  explicit Digits(int s) : d{s / 9, s / 3 % 3, s % 3} {}
};
struct Ends {  // for each axis, whether a node begins, and ends, where the piece does
  bool is[3][2];
};
// Whether a sub-face of a node lies in a zero of the piece.
bool is_part(int sub_face, int zero, const Ends& ends) {
  const Digits s(sub_face), z(zero);
  for (int a = 0; a < 3; ++a)
    if (z.d[a] != 2 && !(s.d[a] == z.d[a] && ends.is[a][z.d[a]])) return false;
  return true;
}

class SignTest {
 public:
  SignTest(const VPiece& piece, const VEntry& entry, const size_t* n, Units* units)
      : piece_(piece), entry_(entry), n_(n), units_(*units), degree_(n[0] + n[1] + n[2] - 3) {}

  // c: times their binomials.
  void run(std::vector<Big> c) {
    for (int zero = 0; zero < kWholeBox; ++zero)
      if (is_zero(zero))
        require(is_all_zero(c, zero), "V2", "N is not 0 on the zero", uint64_t(zero));
    const Ends ends = {{{true, true}, {true, true}, {true, true}}};
    if (entry_.tree[0] != 0) drop_binomials(&c);
    visit(std::move(c), ends, 0);
  }

 private:
  bool is_zero(int s) const { return (entry_.zeros >> s & 1) != 0; }
  bool is_all_zero(const std::vector<Big>& c, int sub_face) const {  // on a sub-face
    const Digits s(sub_face);
    size_t lo[3], hi[3];
    for (int a = 0; a < 3; ++a) {
      lo[a] = s.d[a] == 1 ? n_[a] - 1 : 0;
      hi[a] = s.d[a] == 0 ? 1 : n_[a];
    }
    for (size_t i = lo[0]; i < hi[0]; ++i)
      for (size_t j = lo[1]; j < hi[1]; ++j)
        for (size_t k = lo[2]; k < hi[2]; ++k)
          if (c[(i * n_[1] + j) * n_[2] + k].sign() != 0) return false;
    return true;
  }
  void drop_binomials(std::vector<Big>* c) const {
    Big common = 1;
    std::vector<Big> factors;
    for (size_t i = 0; i < n_[0]; ++i)
      for (size_t j = 0; j < n_[1]; ++j)
        for (size_t k = 0; k < n_[2]; ++k) {
          factors.push_back(Big(binomial(n_[0] - 1, i)) * Big(binomial(n_[1] - 1, j)) *
                            Big(binomial(n_[2] - 1, k)));
          common = common * divide(factors.back(), gcd(common, factors.back()), nullptr);
        }
    for (size_t i = 0; i < c->size(); ++i) (*c)[i] = (*c)[i] * divide(common, factors[i], nullptr);
  }
  void visit(std::vector<Big> c, const Ends& ends, uint64_t level) {
    const uint64_t bits = 4 * uint64_t(piece_.bits) + level * degree_;
    units_.add(1 + uint64_t(c.size()) * degree_ * bits / 16384);
    const uint8_t symbol = entry_.tree[next_++];
    if (symbol == 0) return leaf(c, ends);
    const int axis = symbol - 1;
    std::vector<Big> high = halve(axis, &c);
    Ends low_ends = ends, high_ends = ends;
    low_ends.is[axis][1] = false, high_ends.is[axis][0] = false;
    visit(std::move(c), low_ends, level + 1);
    visit(std::move(high), high_ends, level + 1);
  }
  // Leaves the lower half, returns the upper one.
  std::vector<Big> halve(int axis, std::vector<Big>* low) const {
    std::vector<Big> high(low->size());
    size_t stride = 1;
    for (int a = axis + 1; a < 3; ++a) stride *= n_[a];
    const size_t n = n_[axis];
    std::vector<Big> line(n);
    for (size_t block = 0; block < low->size(); block += stride * n)
      for (size_t start = block; start < block + stride; ++start) {
        for (size_t k = 0; k < n; ++k) line[k] = (*low)[start + k * stride];
        for (size_t s = 0; s < n; ++s) {
          const size_t left = n - 1 - s;
          (*low)[start + s * stride] = shifted(line[0], int64_t(left));
          high[start + left * stride] = shifted(line[left], int64_t(left));
          for (size_t k = 0; k < left; ++k) line[k] = line[k] + line[k + 1];
        }
      }
    return high;
  }
  void leaf(const std::vector<Big>& c, const Ends& ends) const {
    bool has_zero = false;
    for (const Big& x : c) {
      require(x.sign() >= 0, "V2", "N has a negative coefficient on a leaf");
      has_zero = has_zero || x.sign() == 0;
    }
    for (int s = 0; has_zero && s <= kWholeBox; ++s) {
      bool is_in_zero = false;
      for (int zero = 0; zero < kWholeBox; ++zero)
        is_in_zero = is_in_zero || (is_zero(zero) && is_part(s, zero, ends));
      require(is_in_zero || !is_all_zero(c, s), "V2",
              "N has no positive coefficient on a leaf's sub-face", uint64_t(s));
    }
  }

  const VPiece& piece_;
  const VEntry& entry_;
  const size_t* n_;
  Units& units_;
  const uint64_t degree_;
  size_t next_ = 0;
};

}  // namespace
std::vector<Big> coefficients_of_n(const VPiece& piece, Units* units) {
  const uint64_t limbs = 2 + uint64_t(piece.bits) / 32, doubled = piece.times(2);
  units->add(2 + (piece.is_rational ? doubled : piece.count()) * doubled * limbs * limbs / 256);
  return Determinant(piece).take();
}
void check_determinant(const VPiece& piece, const VEntry& entry, bool is_reversed,
                       const bool* may_vanish, Units* units) {
  const Ends whole = {{{true, true}, {true, true}, {true, true}}};
  for (int zero = 0; zero < kWholeBox; ++zero) {
    if ((entry.zeros >> zero & 1) == 0) continue;
    const Digits z(zero);
    int fixed = 0, face = 0;
    for (int a = 0; a < 3; ++a)
      if (z.d[a] != 2) ++fixed, face = 2 * a + z.d[a];
    require(fixed > 1 || may_vanish[face], "V2",
            "a zero is a face that is neither collapsed nor in X");
    for (int other = 0; other < kWholeBox; ++other)
      require(other == zero || (entry.zeros >> other & 1) == 0 || !is_part(zero, other, whole),
              "V2", "a zero is a part of another one");
  }
  units->id = "V2";
  std::vector<Big> c = coefficients_of_n(piece, units);
  for (size_t i = 0; is_reversed && i < c.size(); ++i) c[i] = -c[i];
  size_t n[3];
  for (size_t a = 0; a < 3; ++a) n[a] = (piece.is_rational ? 4 : 3) * (piece.n[a] - 1);
  SignTest(piece, entry, n, units).run(std::move(c));
}
