// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_sheet.h: whether S1 holds on a node, and which sheet of a box the node belongs to: section 4 of
// docs/certificates/star-box.md and star-box-2.md.
#pragma once
#include "star_compose.h"
#include "star_rounded.h"

// S1 on the node for the sheet's centres; is_strict: S1 of version 1. REQUIRES the node's g.
bool star_test(const Patch& p, Node* node, const Sheet& sheet, bool is_strict);

// What is known of a separator on a node: nothing, the coefficients in Bernstein's basis, or the sign of all of them;
// if that is 0, for they differ, the coefficients are needed for the children.
struct SignOn {
  int sign = kUnknown;
  Rounded coefficients;
};

typedef std::vector<SignOn> Signs;  // of all separators of a box

class SheetTest {  // in one star box
 public:
  SheetTest(const Box& box, int version, Units* units);
  // What follows for child c of a node of which every sign is known, or for a root (nullptr).
  Signs begin(const Patch& p, const Signs* of_parent, int c);
  // The number of the sheet to which the node belongs, or -1. REQUIRES the node's g.
  int sheet_of(const Patch& p, Node* node, Signs* signs);
  // Finds out all signs on the node of the last call of sheet_of. The result is the number of limbs that they have.
  size_t complete(const Patch& p, const Node& node, Signs* signs);

 private:
  bool has_signs(const Sheet& sheet, const Patch& p, const Node& node, Signs* signs);
  int sign(size_t separator, const Patch& p, const Node& node, SignOn* known);
  const LocalNet& local(const Patch& p, const Node& node);

  const Box& box_;
  const bool is_strict_;  // S1 of version 1
  Units* const units_;
  std::unique_ptr<LocalNet> local_;  // of the node, once needed
};
