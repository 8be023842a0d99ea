// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/jacobian_sign.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/vmodel/jacobian_tree_internal.h"
#include "solids/vmodel/piece_cutter.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using internal::TreeEnd;
using internal::TreeResult;
using Index3 = std::array<std::size_t, 3>;

constexpr std::size_t kPiecesAtOnce = 256;
constexpr std::uint32_t kWholePiece = std::uint32_t{1} << 26;

// A cell while its pieces are decided.
class CellDecider {
 public:
  CellDecider(const VModel& model, std::size_t cell, std::size_t max_nodes)
      : model_(&model),
        cell_(cell),
        max_nodes_(max_nodes),
        breaks_{model.breaks(cell, 0), model.breaks(cell, 1), model.breaks(cell, 2)},
        cutter_(model.cell(cell), breaks_),
        grid_(cutter_.grid()),
        // A left-handed cell that is not reversed may be folded, too.
        sign_(model.is_reversed(cell) || model.hand(cell) < 0 ? -1 : 1) {}

  void decide(std::size_t number, VDeterminants& out) const {
    const Index3 piece = grid_.index_of(number);
    const RoundedJacobian rounded = rounded_jacobian(cutter_.rounded(piece));
    if (rounded.is_positive(sign_)) return;
    TreeResult result = internal::search_tree(rounded, sign_, max_nodes_);
    std::uint32_t zeros = 0;
    if (result.end == TreeEnd::kUncertain) {
      ++out.num_exact;
      const ExactJacobian exact = exact_jacobian(cutter_.exact(piece));
      zeros = internal::zeros_of(exact);
      if (auto finding = finding_of_zeros(piece, zeros))
        return out.findings.push_back(std::move(*finding));
      result = internal::search_tree(exact, sign_, zeros, max_nodes_);
    }
    if (result.end == TreeEnd::kTooLarge) look_below(piece, rounded, result);
    if (result.end != TreeEnd::kProved) return out.findings.push_back(finding_of(piece, result));
    if (zeros == 0 && result.tree.size() == 1) return;
    for (unsigned n = 0; n < 26; ++n) out.num_zeros += zeros >> n & 1;
    out.proofs.push_back({model_->first_piece(cell_) + number, zeros, std::move(result.tree)});
  }

 private:
  using Box = std::array<std::array<Rational, 2>, 3>;

  Rational parameter(std::size_t axis, const Index3& piece, const Rational& local) const {
    const Rational &a = breaks_[axis][piece[axis]], &b = breaks_[axis][piece[axis] + 1];
    return a + (b - a) * local;
  }
  Box sub_face_box(const Index3& piece, unsigned number) const {
    const auto s = internal::sub_face_places(number);
    Box out;
    for (std::size_t a = 0; a < 3; ++a)
      out[a] = {breaks_[a][piece[a] + (s[a] == 1 ? 1 : 0)],
                breaks_[a][piece[a] + (s[a] == 0 ? 0 : 1)]};
    return out;
  }
  JacobianFinding finding_at(JacobianFinding::Kind kind, Box box) const {
    JacobianFinding out;
    out.kind = kind;
    out.cell = static_cast<std::uint32_t>(cell_);
    out.box = std::move(box);
    return out;
  }

  // A zero that is all of the piece, or a face of it that is neither border nor collapsed.
  std::optional<JacobianFinding> finding_of_zeros(const Index3& piece, std::uint32_t zeros) const {
    if ((zeros & kWholePiece) != 0)
      return finding_at(JacobianFinding::Kind::kFlat, sub_face_box(piece, 26));
    for (unsigned n = 0; n < 26; ++n) {
      const auto s = internal::sub_face_places(n);
      const auto free = static_cast<std::size_t>(std::count(s.begin(), s.end(), 2u));
      if ((zeros >> n & 1) == 0 || free != 2) continue;
      const auto axis = static_cast<std::size_t>(
          std::find_if(s.begin(), s.end(), [](unsigned x) { return x != 2; }) - s.begin());
      const bool is_at_wall = piece[axis] == (s[axis] == 0 ? 0 : grid_.size[axis] - 1);
      if (!is_at_wall || model_->face(cell_, 2 * axis + s[axis]).is_glued())
        return finding_at(JacobianFinding::Kind::kZeroFace, sub_face_box(piece, n));
    }
    return std::nullopt;
  }

  // The tree got too large where N is small: N may be negative at a point nearby that no halving has met.
  void look_below(const Index3& piece, const RoundedJacobian& rounded, TreeResult& result) const {
    auto point = internal::low_point(rounded, sign_, result.box);
    if (!point) return;
    std::array<Rational, 3> at;
    for (std::size_t a = 0; a < 3; ++a) at[a] = parameter(a, piece, (*point)[a]);
    if (jacobian_sign(model_->cell(cell_), at) * sign_of(Rational(sign_)) >= 0) return;
    result.end = TreeEnd::kNegative;
    result.point = std::move(*point);
  }

  JacobianFinding finding_of(const Index3& piece, const TreeResult& result) const {
    Box box;
    for (std::size_t a = 0; a < 3; ++a) {
      if (result.end == TreeEnd::kTooLarge) {
        const auto ends = result.box.along(a);
        box[a] = {parameter(a, piece, ends[0]), parameter(a, piece, ends[1])};
      } else {
        const Rational at = parameter(a, piece, result.point[a]);
        box[a] = {at, at};
      }
    }
    if (result.end == TreeEnd::kTooLarge)
      return finding_at(JacobianFinding::Kind::kUndecided, std::move(box));
    const Sign sign = result.end == TreeEnd::kZero
                          ? Sign::kZero
                          : (sign_ < 0 ? Sign::kPositive : Sign::kNegative);
    JacobianPlace place{piece, {box[0][0], box[1][0], box[2][0]}, sign};
    const auto kind = result.end == TreeEnd::kZero ? JacobianFinding::Kind::kZero
                                                   : JacobianFinding::Kind::kFolded;
    JacobianFinding out = finding_at(kind, std::move(box));
    out.places.push_back(std::move(place));
    return out;
  }

  const VModel* model_;
  std::size_t cell_, max_nodes_;
  std::array<std::vector<Rational>, 3> breaks_;
  PieceCutter cutter_;
  Grid<3> grid_;
  int sign_;
};

// The place that told the cell's hand. REQUIRES that there is one.
JacobianPlace hand_place(const VModel& model, std::size_t cell) {
  const VVolume& volume = model.cell(cell);
  std::array<std::vector<Rational>, 3> knots, breaks;
  Grid<3> spans;
  for (std::size_t a = 0; a < 3; ++a) {
    knots[a] = internal::breaks_of(volume.axis(a));
    breaks[a] = model.breaks(cell, a);
    spans.size[a] = knots[a].size() - 1;
  }
  JacobianPlace out;
  for (std::size_t n = 0; n < spans.count(); ++n) {
    const Index3 span = spans.index_of(n);
    for (std::size_t a = 0; a < 3; ++a) {
      out.at[a] = (knots[a][span[a]] + knots[a][span[a] + 1]) / Rational(2);
      const auto above = std::upper_bound(breaks[a].begin(), breaks[a].end(), out.at[a]);
      out.piece[a] = static_cast<std::size_t>(above - breaks[a].begin()) - 1;
    }
    out.sign = jacobian_sign(volume, out.at);
    if (out.sign != 0) break;
  }
  return out;
}

// One finding a cell: the first of the kind that says most.
std::vector<JacobianFinding> best_of_each_cell(std::vector<JacobianFinding> all) {
  std::vector<JacobianFinding> out;
  for (JacobianFinding& f : all) {
    if (out.empty() || out.back().cell != f.cell) {
      out.push_back(std::move(f));
    } else if (f.kind < out.back().kind) {
      out.back() = std::move(f);
    }
  }
  return out;
}

// Moves a place with a sign off the piece's border: by continuity the sign is the same near enough.
void move_inside(const VModel& model, std::size_t cell, JacobianPlace& place) {
  std::array<Rational, 3> inward;  // to the middle
  bool is_inside = true;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto breaks = model.breaks(cell, a);
    const Rational &low = breaks[place.piece[a]], &high = breaks[place.piece[a] + 1];
    if (low < place.at[a] && place.at[a] < high) continue;
    inward[a] = (low + high) / Rational(2) - place.at[a];
    is_inside = false;
  }
  if (is_inside) return;
  for (Rational step(1);; step /= Rational(2)) {
    std::array<Rational, 3> at = place.at;
    for (std::size_t a = 0; a < 3; ++a) at[a] += step * inward[a];
    if (jacobian_sign(model.cell(cell), at) != place.sign) continue;
    place.at = std::move(at);
    return;
  }
}

// Adds the second place of a folded cell; without one, the cell is called left-handed.
void complete(const VModel& model, JacobianFinding& finding) {
  if (finding.kind != JacobianFinding::Kind::kFolded) return;
  move_inside(model, finding.cell, finding.places[0]);
  for (std::size_t a = 0; a < 3; ++a)
    finding.box[a] = {finding.places[0].at[a], finding.places[0].at[a]};
  if (model.hand(finding.cell) == 0) {
    finding.kind = JacobianFinding::Kind::kLeftHanded;
    return;
  }
  finding.places.push_back(hand_place(model, finding.cell));
  if (finding.places[0].sign < 0) std::swap(finding.places[0], finding.places[1]);
}

JacobianFinding left_handed(const VModel& model, std::size_t cell) {
  JacobianFinding out;
  out.kind = JacobianFinding::Kind::kLeftHanded;
  out.cell = static_cast<std::uint32_t>(cell);
  out.places.push_back(hand_place(model, cell));
  for (std::size_t a = 0; a < 3; ++a) out.box[a] = {out.places[0].at[a], out.places[0].at[a]};
  return out;
}

// Decides pieces begin, ..., end - 1 of the cell; after a fold nothing more is asked of them.
void decide_some(const CellDecider& cell, std::size_t begin, std::size_t end, VDeterminants& out) {
  for (std::size_t number = begin; number < end; ++number) {
    const std::size_t before = out.findings.size();
    cell.decide(number, out);
    if (out.findings.size() > before && out.findings.back().kind == JacobianFinding::Kind::kFolded)
      return;
  }
}

// Cells from `begin` that together have few pieces, or one cell; the end.
std::size_t end_of_batch(const VModel& model, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < model.num_cells() &&
         model.first_piece(end + 1) - model.first_piece(begin) <= kPiecesAtOnce)
    ++end;
  return end;
}

std::vector<VDeterminants> decide_large_cell(const VModel& model, std::size_t cell,
                                             const JacobianOptions& options) {
  const auto pieces =
      static_cast<std::size_t>(model.first_piece(cell + 1) - model.first_piece(cell));
  const CellDecider decider(model, cell, options.max_nodes);
  std::vector<VDeterminants> parts(num_chunks(pieces, kPiecesAtOnce));
  parallel_for(pieces, kPiecesAtOnce, options.jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 decide_some(decider, begin, end, parts[chunk]);
               });
  return parts;
}

}  // namespace

VDeterminants decide_determinants(const VModel& model, const JacobianOptions& options) {
  std::vector<std::array<std::size_t, 2>> batches;
  for (std::size_t begin = 0; begin < model.num_cells(); begin = batches.back()[1])
    batches.push_back({begin, end_of_batch(model, begin)});
  const auto is_large = [&](std::size_t cell) {
    return model.piece_grid(cell).count() > kPiecesAtOnce;
  };
  std::vector<std::vector<VDeterminants>> found(batches.size());
  parallel_for(batches.size(), 1, options.jobs, [&](std::size_t, std::size_t b, std::size_t) {
    if (is_large(batches[b][0])) return;
    VDeterminants& out = found[b].emplace_back();
    for (std::size_t cell = batches[b][0]; cell < batches[b][1]; ++cell)
      decide_some(CellDecider(model, cell, options.max_nodes), 0, model.piece_grid(cell).count(),
                  out);
  });
  std::vector<VDeterminants> parts;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    if (is_large(batches[b][0])) found[b] = decide_large_cell(model, batches[b][0], options);
    std::move(found[b].begin(), found[b].end(), std::back_inserter(parts));
  }
  VDeterminants out;
  for (VDeterminants& part : parts) {
    std::move(part.proofs.begin(), part.proofs.end(), std::back_inserter(out.proofs));
    std::move(part.findings.begin(), part.findings.end(), std::back_inserter(out.findings));
    out.num_zeros += part.num_zeros;
    out.num_exact += part.num_exact;
  }
  for (const std::uint32_t cell : model.left_handed())
    if (!model.is_reversed(cell)) out.findings.push_back(left_handed(model, cell));
  std::stable_sort(
      out.findings.begin(), out.findings.end(),
      [](const JacobianFinding& a, const JacobianFinding& b) { return a.cell < b.cell; });
  out.findings = best_of_each_cell(std::move(out.findings));
  for (JacobianFinding& finding : out.findings) complete(model, finding);
  return out;
}

}  // namespace veritope
