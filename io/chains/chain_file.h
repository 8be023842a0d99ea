// SPDX-License-Identifier: LGPL-3.0-or-later
// io/chains/chain_file.h: the file of an expression of solids. Format: docs/formats/chain-files.md.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "interval/exact_box.h"
#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/chains/expression_text.h"

namespace veritope {

/// The format of an operand that is a chain file itself.
inline constexpr std::string_view kChainFormat = "chain";

struct ChainOperand {
  std::string name;    ///< in the expression
  std::string path;    ///< relative to the folder of the chain file, or absolute
  std::string sha256;  ///< of its bytes: 64 lower-case hexadecimal digits
  std::string format;  ///< "stl", ..., or kChainFormat
};

/// Operands are in the order in which the expression names them first. Nothing is known about their files.
struct ChainFile {
  std::string tool;
  ExpressionTree tree;
  std::vector<ChainOperand> operands;
  ExactBox<3> box;
};

/// Whether the bytes begin like a JSON object, and name the schema of chain files among the first kMostChainStart.
inline constexpr std::size_t kMostChainStart = std::size_t{1} << 16;
bool looks_like_chain(const Source& source);

/// @error  kSyntax, kTruncated, kOverLimit, with the line and the offending value: among others for an operand that
///         the expression does not name, and for a box without an interior
Result<ChainFile> read_chain(const Source& source, const ReadLimits& limits);

/// The text that read_chain reads. REQUIRES operands in the order of the tree's numbers.
std::string write_chain(const ChainFile& chain);

}  // namespace veritope
