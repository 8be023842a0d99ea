// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/expression_operands.h: the files of an expression's operands: read, compared with what a chain file says of them,
// and decided; equal solids become one variable.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/certification.h"
#include "io/chains/chain_file.h"
#include "solids/expression/operand.h"
#include "verify/certify/expression_points_certifier.h"

namespace veritope::cli {

/// A file as an operand: a solid, or an expression of solids.
struct ExpressionOperand {
  Formula formula;
  ExpressionSize size;
  ExactBox<3> box;  ///< around the solid; that of a chain file
  std::string sha256, format;
  std::uint64_t bytes = 0;
};

/// Whether a regular file begins like a chain file. Reads its beginning only.
bool is_chain_file(const std::string& path);

/// The least box that contains all of them. REQUIRES one.
ExactBox<3> hull_of(const std::vector<ExpressionOperand>& operands);

/// An expression whose operands are known.
struct BoundExpression {
  const ExpressionTree* tree = nullptr;
  const std::vector<ExpressionOperand>* operands = nullptr;  ///< in the order of the tree's numbers
  const std::vector<std::string>* names = nullptr;           ///< likewise
  ExactBox<3> box;
};

class ExpressionOperands {
 public:
  /// @param settings  how operands are read and decided; its model, picture and format are not used
  ExpressionOperands(const CertifySettings& settings, Progress& progress)
      : settings_(settings), progress_(progress) {}

  /// A file that boolean names. Nothing: it was refused, with a complaint that begins with `label`; exit() says how.
  std::optional<ExpressionOperand> load(const std::string& path, const std::string& label);
  /// A chain file and all its operands. Likewise.
  std::optional<ExpressionOperand> load_chain(const std::string& path);
  /// Likewise; the error may be kOverLimit, or kBadArgument if an operand is not in the interior of the box.
  Result<ExpressionOperand> combine(const BoundExpression& expression);

  /// The least box around the vertices, control points and boxes of all solids that a formula names. Nothing if it is
  /// constant. REQUIRES solids that were not taken yet.
  std::optional<ExactBox<3>> box_of(const Formula& formula) const;

  /// The first of 5, 1, 4, 3, 0 that occurred.
  ExitCode exit() const { return exit_; }
  /// The files that were read, in order.
  const std::vector<std::string>& files() const { return files_; }
  std::size_t num_solids() const { return solids_.size(); }
  /// Whether some solids are patches.
  bool has_patches() const { return has_patches_; }
  /// The solids, in the order of the variables; those of meshes get their look-up. May be called once.
  std::vector<ExpressionSolid> take_solids();
  /// In the order of the variables: the path at which each was read first; "the box" of a complement.
  const std::vector<std::string>& solid_names() const { return solid_names_; }
  /// Why checkers do not read an operand; empty if they read all.
  const std::string& no_certificate() const { return no_certificate_; }

 private:
  using Solid = std::variant<TriangleMesh, ExactBox<3>, std::unique_ptr<const PatchComplex>>;

  std::optional<ExpressionOperand> load(const std::string& path, const std::string& label,
                                        const ChainOperand* expected);
  std::optional<ExpressionOperand> read_chain_of(const std::string& path, const ModelBytes& bytes,
                                                 const std::string& label);
  std::optional<ExpressionOperand> decide(const std::string& path, const std::string& label,
                                          std::optional<FormatId> format,
                                          const std::string& sha256);
  Formula add(Solid solid, ExpressionSolid source);
  void exclude_from_certificates(const std::string& path, const std::string& why);
  std::uint32_t variable_of(const ExactBox<3>& box);
  std::nullopt_t refuse(ExitCode exit, const std::string& text);

  const CertifySettings& settings_;
  Progress& progress_;
  ExitCode exit_ = kExitValid;
  bool has_patches_ = false;
  std::string no_certificate_;
  std::vector<std::string> files_;
  std::vector<Solid> solids_;
  std::vector<std::string> solid_names_;
  std::vector<ExpressionSolid> sources_;  ///< of the solids, without their operands
  /// By SHA-256 and format; nothing: refused.
  std::map<std::pair<std::string, std::string>, std::optional<ExpressionOperand>> known_;
  std::map<std::string, std::uint32_t> boxes_;  ///< the variables of boxes, by their text
  std::vector<std::string> open_;  ///< the chain files around the one that is being read
};

}  // namespace veritope::cli
