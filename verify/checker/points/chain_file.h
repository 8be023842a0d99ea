// SPDX-License-Identifier: Apache-2.0 OR MIT
// chain_file.h: one chain file; docs/formats/chain-files.md.
#pragma once
#include "../patches/star.h"

struct ExpressionNode {
  enum Kind { kLeaf, kUnion, kIntersection, kDifference, kComplement } kind;
  uint32_t left,
      right;  // nodes that stand before it; of a leaf: left is a number, of kComplement the only part
};

struct ChainOperand {
  std::string name, path, hash, format;
};
struct Bounds3 {  // a closed box
  Ratio lo[3], hi[3];
};
struct ChainFile {
  std::vector<ChainOperand> operands;  // in the order in which the expression names them first
  std::vector<ExpressionNode> nodes;   // the root is the last one; leaves have numbers of operands
  Bounds3 box;
};

const uint64_t kMostLeaves = 10000, kMostOperators = 100000;  // of an expression with those in it

// Refuses what the page forbids.
ChainFile read_chain_file(const std::string& text);
