// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_sheet.cc: separators, and the sheets of a box: docs/certificates/star-box-2.md, section 4.
#include "star_sheet.h"

namespace {

Shape composed_shape(const Patch& p, int degree) {
  return Shape{p.shape.is_triangle, degree * p.shape.p, degree * p.shape.q};
}
uint64_t count_of(const Patch& p, int degree) { return uint64_t(composed_shape(p, degree).count()); }
uint64_t limbs_of(const Separator& q, const Patch& p, int level) {
  return 2 + uint64_t(q.degree * (p.bits_at(level) + q.length)) / 64;
}
// The units of work of a separator that is composed on a node: its products, each as the square of the number of limbs.
uint64_t cost_of_products(const Separator& q, const Patch& p, int level) {
  const uint64_t limbs = limbs_of(q, p, level);
  const uint64_t products = count_of(p, 1) * count_of(p, q.degree - 1);
  return 1 + uint64_t(q.degree) * products * limbs * limbs / 128;
}
// The quarter of its coefficients that belongs to a child of a node that has them; triangles need more midpoints.
uint64_t cost_of_quarter(const Separator& q, const Patch& p) {
  const Shape s = composed_shape(p, q.degree);
  return 2 + uint64_t(s.count()) * uint64_t(s.is_triangle ? s.p * s.p : s.p + s.q) / 256;
}

}  // namespace

SheetTest::SheetTest(const Box& box, int version, Units* units)
    : box_(box), is_strict_(version == 1), units_(units) {}

Signs SheetTest::begin(const Patch& p, const Signs* of_parent, int c) {
  local_.reset();
  Signs signs(box_.separators.size());
  for (size_t i = 0; of_parent != nullptr && i < signs.size(); ++i) {
    const SignOn& before = (*of_parent)[i];
    const Separator& q = box_.separators[i];
    if (before.sign != 0) {
      signs[i].sign = before.sign;
    } else {
      units_->add(cost_of_quarter(q, p));
      signs[i].coefficients = quarter(composed_shape(p, q.degree), before.coefficients, c);
    }
  }
  return signs;
}

int SheetTest::sheet_of(const Patch& p, Node* node, Signs* signs) {
  for (const Separator& q : box_.separators)
    require(are_short(p.shape, p.bits + q.length), "C2",
            "a separator is too long for the degree of a patch, bits", uint64_t(q.length));
  for (size_t i = 0; i < box_.sheets.size(); ++i) {
    units_->add(p.cost_of_s1(node->level));
    if (star_test(p, node, box_.sheets[i], is_strict_) &&
        has_signs(box_.sheets[i], p, *node, signs))
      return int(i);
  }
  return -1;
}

bool SheetTest::has_signs(const Sheet& sheet, const Patch& p, const Node& node, Signs* signs) {
  for (size_t i = 0; i < sheet.signs.size(); ++i)
    if (sheet.signs[i] != 0 && sign(i, p, node, &(*signs)[i]) != sheet.signs[i]) return false;
  return true;
}

int SheetTest::sign(size_t separator, const Patch& p, const Node& node, SignOn* known) {
  if (known->sign != kUnknown) return known->sign;
  if (!known->coefficients.c.empty()) known->sign = sign_of(known->coefficients);
  if (known->sign != kUnknown) return known->sign;
  const Separator& q = box_.separators[separator];
  units_->add(cost_of_products(q, p, node.level));
  const Block all = composed(q, local(p, node));
  known->sign = sign_of(all);
  if (known->sign == 0) known->coefficients = rounded(composed_shape(p, q.degree), all);
  return known->sign;
}

size_t SheetTest::complete(const Patch& p, const Node& node, Signs* signs) {
  size_t limbs = 0;
  for (size_t i = 0; i < signs->size(); ++i) {
    SignOn& known = (*signs)[i];
    if (sign(i, p, node, &known) != 0) known.coefficients = Rounded();
    limbs += known.coefficients.c.size();
  }
  return limbs;
}

const LocalNet& SheetTest::local(const Patch& p, const Node& node) {
  if (!local_) local_.reset(new LocalNet(local_net(p, node, box_.sheets[0].c[0])));
  return *local_;
}
