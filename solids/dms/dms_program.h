// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_program.h: the recurrences of the basis functions of a tetrahedron ("The map" in
// docs/formats/dms-files.md), laid out once, so that they can be run at many points: in intervals, which enclose, or
// in binary64, which is approximate in all parts, the choice of independent knots included.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "interval/ring_numbers.h"
#include "predicates/entry_path.h"
#include "solids/dms/dms_model.h"
#include "splines/dms_spline.h"

namespace veritope {

/// The sets of knots that the recurrences of the N_γ, |γ| = n - 1, of one tetrahedron meet.
template <Ring R>
struct DmsProgram {
  static constexpr std::uint32_t kNone = 0xffffffff;
  /// M(u|V) is the sum of the coordinate m of u in the frame times the value of part m; parts kNone are zero.
  struct Node {
    std::uint32_t frame = 0;
    std::array<std::uint32_t, 4> part{};  ///< a set of four knots has none
  };
  /// V_γ and knot `index` of a corner once more. Its value is not computed: derivatives need its parts.
  struct Doubled {
    std::uint32_t corner = 0;
    int index = 0;
    Node node;
  };
  struct Basis {
    TetrahedralIndex gamma{};
    std::uint32_t frame = 0;  ///< of W_γ
    std::uint32_t node = 0;   ///< of V_γ
    std::vector<Doubled> doubled;
  };
  std::vector<SimplexFrame<R>> frames;                     ///< the exact ones in the ring
  std::vector<std::array<const ExactPoint3*, 4>> corners;  ///< of each frame; empty in binary64
  std::vector<Node> nodes;            ///< parts come before what they are parts of
  std::vector<std::uint32_t> leaves;  ///< the nodes of four knots
  std::vector<Basis> basis;
};

/// What a run at a point leaves behind.
template <Ring R>
struct DmsRun {
  std::array<R, 3> point{};
  std::vector<std::array<R, 4>> barycentric;  ///< of the point, in each frame
  std::vector<R> value;                       ///< of each node
};

/// Runs the program at u; contains(frame) says which tetrahedra of four knots contain the point.
/// For intervals REQUIRES a live ScopedUpward.
template <Ring R, typename Contains>
void run_program(const DmsProgram<R>& program, const std::array<R, 3>& u, Contains contains,
                 DmsRun<R>& run);

/// The gradient of M(.|V) at the point of the run, by eq. 2 of [HHQ04]. `degree` is that of M.
template <Ring R>
std::array<R, 3> program_gradient(const DmsProgram<R>& program, const DmsRun<R>& run,
                                  const typename DmsProgram<R>::Node& node, int degree);

/// Whether rounding may have given the frame of these points its volume: sets of knots with such frames count as flat
/// in binary64.
bool is_nearly_flat(const SimplexFrame<double>& frame,
                    const std::array<std::array<double, 3>, 4>& points);

/// The programs of a model's tetrahedra, each laid out when it is needed first; so one thread at a time.
template <Ring R>
class DmsPrograms {
 public:
  /// The model must outlive this object. REQUIRES a model without defects and with shared control points.
  /// @param with_doubled  whether derivatives with respect to knots will be needed
  DmsPrograms(const DmsModel& model, bool with_doubled);
  ~DmsPrograms();

  /// @cost for the first time the frames of the sets, for intervals exact ones, some 30 us each
  /// For R = Interval REQUIRES a live ScopedUpward; for R = double, that no W_γ with |γ| = n - 1 is nearly flat.
  const DmsProgram<R>& of(std::uint32_t tetrahedron);

 private:
  const DmsModel& model_;
  bool with_doubled_;
  std::vector<ExactPoint3> knots_;
  std::vector<std::size_t> first_knot_;
  std::vector<std::unique_ptr<DmsProgram<R>>> programs_;
};

extern template class DmsPrograms<double>;
extern template class DmsPrograms<Interval>;

// ---- bodies

template <Ring R, typename Contains>
void run_program(const DmsProgram<R>& program, const std::array<R, 3>& u, Contains contains,
                 DmsRun<R>& run) {
  run.point = u;
  run.barycentric.resize(program.frames.size());
  for (std::size_t f = 0; f < program.frames.size(); ++f)
    run.barycentric[f] = program.frames[f].barycentric(u);
  run.value.assign(program.nodes.size(), R());
  for (const std::uint32_t leaf : program.leaves) {
    const std::uint32_t f = program.nodes[leaf].frame;
    if (contains(f)) run.value[leaf] = program.frames[f].height;
  }
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const auto& node = program.nodes[i];
    const auto& at = run.barycentric[node.frame];
    for (std::size_t m = 0; m < 4; ++m)
      if (node.part[m] != DmsProgram<R>::kNone)
        run.value[i] = run.value[i] + at[m] * run.value[node.part[m]];
  }
}

template <Ring R>
std::array<R, 3> program_gradient(const DmsProgram<R>& program, const DmsRun<R>& run,
                                  const typename DmsProgram<R>::Node& node, int degree) {
  std::array<R, 3> sum{};
  const auto& lambda = program.frames[node.frame].lambda;
  const R factor = RingNumbers<R>::ratio(degree, 1);
  for (std::size_t m = 0; m < 4; ++m) {
    if (node.part[m] == DmsProgram<R>::kNone) continue;
    const R scaled = factor * run.value[node.part[m]];
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + lambda[m][c + 1] * scaled;
  }
  return sum;
}

}  // namespace veritope
