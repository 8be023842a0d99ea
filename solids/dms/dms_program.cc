// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_program.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_table_internal.h"

namespace veritope {
namespace {

constexpr double kRelative = 0x1p-50, kLeastSize = 1e-100, kMostSize = 1e100;

template <Ring R>
class ProgramBuilder {
 public:
  ProgramBuilder(internal::DmsTable& table, DmsProgram<R>& program)
      : table_(table), program_(program) {}

  std::uint32_t frame(const SimplexFrame<Rational>& exact) {
    const auto [place, is_new] =
        frames_.emplace(&exact, static_cast<std::uint32_t>(program_.frames.size()));
    if (is_new) {
      program_.frames.push_back(frame_in_ring<R>(exact));
      program_.corners.push_back(table_.corners(exact));
    }
    return place->second;
  }
  std::uint32_t node(const KnotSet& set) {
    const auto found = nodes_.find(set);
    if (found != nodes_.end()) return found->second;
    const std::optional<typename DmsProgram<R>::Node> made = make(set);
    std::uint32_t number = DmsProgram<R>::kNone;
    if (made) {
      number = static_cast<std::uint32_t>(program_.nodes.size());
      program_.nodes.push_back(*made);
      if (set.size() == 4) program_.leaves.push_back(number);
    }
    return nodes_.emplace(set, number).first->second;
  }
  // The node of a set, whose parts are nodes; nothing if it is flat.
  std::optional<typename DmsProgram<R>::Node> make(const KnotSet& set) {
    const SimplexFrame<Rational>* const exact = table_.frame(set);
    if (exact == nullptr) return std::nullopt;
    typename DmsProgram<R>::Node node;
    node.part.fill(DmsProgram<R>::kNone);
    node.frame = frame(*exact);
    if (set.size() > 4)
      for (std::size_t m = 0; m < 4; ++m) node.part[m] = this->node(set.without(exact->knots[m]));
    return node;
  }

 private:
  internal::DmsTable& table_;
  DmsProgram<R>& program_;
  std::unordered_map<const SimplexFrame<Rational>*, std::uint32_t> frames_;
  std::unordered_map<KnotSet, std::uint32_t, KnotSetHash> nodes_;
};

template <Ring R>
void build(internal::DmsTable& table, int n, bool with_doubled, DmsProgram<R>& program) {
  ProgramBuilder<R> builder(table, program);
  const DmsKnots& knots = table.knots();
  for_each_tetrahedral_index(n - 1, [&](const TetrahedralIndex& gamma) {
    const auto w = knots.tetrahedron(gamma);
    const auto* const exact = table.frame(KnotSet{w[0], w[1], w[2], w[3]});
    VT_CHECK(exact != nullptr, "the four last knots of a basis function are independent");
    typename DmsProgram<R>::Basis basis;
    basis.gamma = gamma;
    basis.frame = builder.frame(*exact);
    const KnotSet set = knots.up_to(gamma);
    basis.node = builder.node(set);
    if (with_doubled)
      for (std::uint32_t m = 0; m < 4; ++m)
        for (int i = 0; i <= gamma[m]; ++i) {
          KnotSet more = set;
          more.insert(knots.number[m][static_cast<std::size_t>(i)]);
          basis.doubled.push_back({m, i, builder.make(more).value()});
        }
    program.basis.push_back(std::move(basis));
  });
}

}  // namespace

Sign3 holds_by_filter(const SimplexFrame<double>& frame, const std::array<double, 3>& u) {
  if (!(std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])}) <= kMostSize))
    return Sign3::kUncertain;
  bool is_inside = true;
  for (const auto& l : frame.lambda) {
    const double a = l[1] * u[0], b = l[2] * u[1], c = l[3] * u[2];
    const double at = l[0] + a + b + c;
    const double size = std::abs(l[0]) + std::abs(a) + std::abs(b) + std::abs(c);
    if (!(size >= kLeastSize && size <= kMostSize)) return Sign3::kUncertain;
    if (-at > kRelative * size) return Sign3::kNegative;
    if (!(at > kRelative * size)) is_inside = false;
  }
  return is_inside ? Sign3::kPositive : Sign3::kUncertain;
}

template <Ring R>
DmsPrograms<R>::DmsPrograms(const DmsModel& model, bool with_doubled)
    : model_(model), with_doubled_(with_doubled), programs_(model.tetrahedra.size()) {
  VT_CHECK(!model.control.is_separate, "programs are those of shared control points");
  for (const DmsCloud& cloud : model.clouds) {
    first_knot_.push_back(knots_.size());
    for (const DmsPoint& knot : cloud) knots_.emplace_back(knot);
  }
}

template <Ring R>
DmsPrograms<R>::~DmsPrograms() = default;

template <Ring R>
const DmsProgram<R>& DmsPrograms<R>::of(std::uint32_t tetrahedron) {
  auto& program = programs_[tetrahedron];
  if (program == nullptr) {
    internal::DmsTable table = internal::make_dms_table(model_, tetrahedron, knots_, first_knot_);
    program = std::make_unique<DmsProgram<R>>();
    build(table, model_.degree, with_doubled_, *program);
  }
  return *program;
}

template class DmsPrograms<double>;
template class DmsPrograms<Interval>;

}  // namespace veritope
