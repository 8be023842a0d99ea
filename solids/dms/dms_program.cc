// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_program.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <unordered_map>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_table.h"

namespace veritope {
namespace {

constexpr double kFlat = 1e-12;  // of d / longest edge^3

// The frames of a tetrahedron's knots in binary64.
class RoundedTable {
 public:
  RoundedTable(const DmsModel& model, std::uint32_t tetrahedron)
      : knots_(internal::dms_knots(model, tetrahedron)) {
    for (std::size_t m = 0; m < 4; ++m)
      for (const KnotNumber number : knots_.number[m]) {
        const DmsPoint& p = model.knot(model.tetrahedra[tetrahedron][m],
                                       static_cast<int>(number % internal::kKnotsOfCorner));
        points_[number] = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
      }
  }
  const DmsKnots& knots() const { return knots_; }
  const SimplexFrame<double>* frame(const KnotSet& set) {
    return internal::choose_frame(set, [this](const auto& four) { return frame_of(four); });
  }

 private:
  const SimplexFrame<double>* frame_of(const std::array<KnotNumber, 4>& four) {
    const std::uint32_t key = static_cast<std::uint32_t>(four[0]) << 24 |
                              static_cast<std::uint32_t>(four[1]) << 16 |
                              static_cast<std::uint32_t>(four[2]) << 8 | four[3];
    const auto [place, is_new] = frames_.try_emplace(key);
    if (is_new) {
      const std::array<std::array<double, 3>, 4> at{points_[four[0]], points_[four[1]],
                                                    points_[four[2]], points_[four[3]]};
      auto frame = simplex_frame<double>(four, at, Sign::kPositive);
      frame.height = std::abs(frame.height);
      if (!is_nearly_flat(frame, at)) place->second = frame;
    }
    return place->second ? &*place->second : nullptr;
  }

  DmsKnots knots_;
  std::array<std::array<double, 3>, 4 * internal::kKnotsOfCorner> points_{};
  std::unordered_map<std::uint32_t, std::optional<SimplexFrame<double>>> frames_;
};

template <typename Table, Ring R>
class ProgramBuilder {
 public:
  ProgramBuilder(Table& table, DmsProgram<R>& program) : table_(table), program_(program) {}

  template <typename Frame>
  std::uint32_t frame(const Frame& of_table) {
    const auto [place, is_new] =
        frames_.emplace(&of_table, static_cast<std::uint32_t>(program_.frames.size()));
    if (is_new) {
      if constexpr (std::same_as<Frame, SimplexFrame<R>>) {
        program_.frames.push_back(of_table);
      } else {
        program_.frames.push_back(frame_in_ring<R>(of_table));
        program_.corners.push_back(table_.corners(of_table));
      }
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
    const auto* const exact = table_.frame(set);
    if (exact == nullptr) return std::nullopt;
    typename DmsProgram<R>::Node node;
    node.part.fill(DmsProgram<R>::kNone);
    node.frame = frame(*exact);
    if (set.size() > 4)
      for (std::size_t m = 0; m < 4; ++m) node.part[m] = this->node(set.without(exact->knots[m]));
    return node;
  }

 private:
  Table& table_;
  DmsProgram<R>& program_;
  std::unordered_map<const void*, std::uint32_t> frames_;
  std::unordered_map<KnotSet, std::uint32_t, KnotSetHash> nodes_;
};

template <typename Table, Ring R>
void build(Table table, int n, bool with_doubled, DmsProgram<R>& program) {
  ProgramBuilder<Table, R> builder(table, program);
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

bool is_nearly_flat(const SimplexFrame<double>& frame,
                    const std::array<std::array<double, 3>, 4>& points) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      longest = std::max(longest, std::abs(points[i][c] - points[(i + 1) % 4][c]));
  return !(std::abs(frame.volume) > kFlat * longest * longest * longest);
}

template <Ring R>
DmsPrograms<R>::DmsPrograms(const DmsModel& model, bool with_doubled)
    : model_(model), with_doubled_(with_doubled), programs_(model.tetrahedra.size()) {
  VT_CHECK(!model.control.is_separate, "programs are those of shared control points");
  if constexpr (std::same_as<R, double>) return;
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
    program = std::make_unique<DmsProgram<R>>();
    if constexpr (std::same_as<R, double>) {
      build(RoundedTable(model_, tetrahedron), model_.degree, with_doubled_, *program);
    } else {
      build(internal::make_dms_table(model_, tetrahedron, knots_, first_knot_), model_.degree,
            with_doubled_, *program);
    }
  }
  return *program;
}

template class DmsPrograms<double>;
template class DmsPrograms<Interval>;

}  // namespace veritope
