// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_sheet.h: whether S1 holds on a node, and which sheet of a box the node belongs to: section 4 of
// docs/certificates/star-box.md and star-box-2.md.
#pragma once
#include "star_compose.h"

// S1 on the node for the sheet's centres; is_strict: S1 of version 1. REQUIRES the node's g.
bool star_test(const Patch& p, Node* node, const Sheet& sheet, bool is_strict);

class SheetTest {  // in one star box
 public:
  SheetTest(const Box& box, int version, Units* units);
  // The number of the sheet to which the node belongs, or -1. REQUIRES the node's g.
  int sheet_of(const Patch& p, Node* node);

 private:
  bool has_signs(const Sheet& sheet, const Patch& p, const Node& node);

  const Box& box_;
  const bool is_strict_;  // S1 of version 1
  Units* const units_;
  std::vector<int> known_;           // signs of the separators on the node, or kUnknown
  std::unique_ptr<LocalNet> local_;  // of the node, once needed
};
