// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_sheet.cc: separators, and the sheets of a box: docs/certificates/star-box-2.md, section 4.
#include "star_sheet.h"

namespace {

const int kUnknown = 2;

uint64_t count_of(const Shape& s, int times) {
  return uint64_t(Shape{s.is_triangle, times * s.p, times * s.q}.count());
}
// The units of work of a separator on a node: its products, each as the square of the number of limbs.
uint64_t cost_of(const Separator& q, const Patch& p, int level) {
  const uint64_t limbs = 2 + uint64_t(q.degree * (p.bits_at(level) + q.length)) / 64;
  const uint64_t products = count_of(p.shape, 1) * count_of(p.shape, q.degree - 1);
  return 1 + uint64_t(q.degree) * products * limbs * limbs / 512;
}

}  // namespace

SheetTest::SheetTest(const Box& box, int version, Units* units)
    : box_(box), is_strict_(version == 1), units_(units), known_(box.separators.size()) {}

int SheetTest::sheet_of(const Patch& p, Node* node) {
  std::fill(known_.begin(), known_.end(), kUnknown);
  local_.reset();
  for (const Separator& q : box_.separators)
    require(are_short(p.shape, p.bits + q.length), "C2",
            "a separator is too long for the degree of a patch, bits", uint64_t(q.length));
  for (size_t i = 0; i < box_.sheets.size(); ++i) {
    units_->add(p.cost_of_s1(node->level));
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
      units_->add(cost_of(q, p, node.level));
      if (!local_) local_.reset(new LocalNet(local_net(p, node, box_.sheets[0].c[0])));
      known_[i] = sign_on(q, *local_);
    }
    if (known_[i] != sheet.signs[i]) return false;
  }
  return true;
}
