// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_sheet.cc: separators, and the sheets of a box: docs/certificates/star-box-2.md, section 4.
#include "star_sheet.h"

#include "star_poly.h"

namespace {

const int kUnknown = 2;

// The place of y1^a y2^b y3^c among the coefficients of degree d: a, then b, then c rising.
size_t place_of(int d, int a, int b, int c) {
  int at = c;
  for (int i = 0; i < b; ++i) at += d - a - i + 1;
  for (int i = 0; i < a; ++i) at += (d - i + 1) * (d - i + 2) / 2;
  return size_t(at);
}

// The sum of coefficient times v1^a v2^b v3^c v4^(d - a - b - c), v = x - o and w: Horner's scheme, variable by
// variable, so that there are few products.
struct Composition {
  int degree;
  const std::vector<Big>& coefficients;
  const Poly* v;

  // The terms of v^power times monomials of degree `left` in the variables from `first` on, without v^power.
  Poly sum(int first, int* power, int left) const {
    Poly r;
    for (int i = first; i < 4; ++i) {
      ++power[i];
      Poly term;
      if (left == 1) {
        term = v[i];
        const Big& f = coefficients[place_of(degree, power[0], power[1], power[2])];
        for (Big& x : term.c) x = x * f;
      } else {
        term = product(v[i], sum(i, power, left - 1));
      }
      --power[i];
      r = i == first ? term : combined(r, term, 1);
    }
    return r;
  }
  int sign() const {
    int power[4] = {0, 0, 0, 0};
    const Poly r = sum(0, power, degree);
    const int first = r.c[0].sign();
    for (const Big& x : r.c)
      if (x.sign() != first) return 0;
    return first;
  }
};

}  // namespace

SheetTest::SheetTest(const Box& box, int version, Units* units)
    : box_(box), is_strict_(version == 1), units_(units), known_(box.separators.size()) {
  for (const Separator& q : box.separators) {
    Form form = {q.degree, {}};
    size_t at = 0;
    for (int a = 0; a <= q.degree; ++a)
      for (int b = 0; a + b <= q.degree; ++b)
        for (int c = 0; a + b + c <= q.degree; ++c) {
          const int up =
              q.scale > 0 ? q.degree - a - b - c : a + b + c;  // times 2^-scale for each y
          form.coefficients.push_back(
              shifted(q.coefficients[at++], int64_t(magnitude(q.scale)) * up));
        }
    forms_.push_back(form);
  }
}

int SheetTest::sheet_of(const Patch& p, Node* node) {
  std::fill(known_.begin(), known_.end(), kUnknown);
  for (const Separator& q : box_.separators)
    require(cost_of(p.shape, p.bits + q.length) != 0, "C2",
            "a separator is too long for the degree of a patch, bits", uint64_t(q.length));
  for (size_t i = 0; i < box_.sheets.size(); ++i) {
    if (!is_strict_) units_->add(p.cost);
    if (star_test(p, node, box_.sheets[i], is_strict_) && has_signs(box_.sheets[i], p, *node))
      return int(i);
  }
  return -1;
}

bool SheetTest::has_signs(const Sheet& sheet, const Patch& p, const Node& node) {
  for (size_t i = 0; i < sheet.signs.size(); ++i) {
    if (sheet.signs[i] == 0) continue;
    if (known_[i] == kUnknown) {
      const Separator& q = box_.separators[i];
      units_->add(uint64_t(q.degree) * cost_of(p.shape, p.bits + q.length));
      known_[i] = sign_on(i, p, node);
    }
    if (known_[i] != sheet.signs[i]) return false;
  }
  return true;
}

int SheetTest::sign_on(size_t separator, const Patch& p, const Node& node) const {
  const int64_t* const o = box_.sheets[0].c[0];
  std::vector<Big> from_o[4] = {{}, {}, {}, coefficients(p, node, 3)};
  for (int k = 0; k < 3; ++k) {
    from_o[k] = coefficients(p, node, k);
    for (size_t i = 0; i < from_o[k].size(); ++i)
      from_o[k][i] = from_o[k][i] - from_o[3][i] * Big(o[k]);
  }
  const Form& form = forms_[separator];
  Poly v[4];
  // At a corner the coefficient is the value: most nodes that fail do so there.
  for (int corner = 0, first = kUnknown; corner < p.shape.sides(); ++corner) {
    const size_t at = size_t(p.shape.on_side(corner, 0));
    for (int k = 0; k < 4; ++k) v[k] = Poly{Shape{p.shape.is_triangle, 0, 0}, {from_o[k][at]}};
    const int sign = Composition{form.degree, form.coefficients, v}.sign();
    if (sign == 0 || (first != kUnknown && sign != first)) return 0;
    first = sign;
  }
  for (int k = 0; k < 4; ++k) v[k] = polynomial(p.shape, from_o[k], -1);
  return Composition{form.degree, form.coefficients, v}.sign();
}
