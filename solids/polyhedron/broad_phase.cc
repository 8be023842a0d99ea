// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/broad_phase.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "robust/base/work_share.h"
#include "solids/polyhedron/broad_phase_internal.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace veritope {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kFlush = 1 << 12;
constexpr std::uint64_t kWorkPerPair = 8;  // deciding a pair costs as much as comparing that many facets with a group
constexpr float kInf = std::numeric_limits<float>::infinity();
// enough to keep several threads busy to the end; a constant, so tasks do not depend on jobs
constexpr std::size_t kTaskGoal = 256;

std::atomic<bool> only_baseline_boxes{false};

struct Box1 {
  float lo[3], hi[3];
};

}  // namespace

// The state of one task's walk.
struct BroadPhaseWalk {
  using Boxes8 = BoxGroups::Boxes8;
  using Ids8 = BoxGroups::Ids8;

  const std::vector<Buffer<Boxes8>>& levels;
  const Buffer<Ids8>& ids;
  const std::vector<std::uint32_t>& order;
  const BoxGroups::Sink& sink;
  std::size_t task;
  std::atomic<std::uint64_t>& total;
  std::uint64_t budget;
  std::uint64_t work = 0;
  std::uint64_t reported = 0;
  std::vector<FacetPair> found;

  void emit(std::uint32_t i, std::uint32_t j) {
    found.emplace_back(order[i], order[j]);
    work += kWorkPerPair;
    if (found.size() == kFlush) flush();
  }
  void flush() {
    if (!found.empty()) sink(task, found);
    found.clear();
  }
  // Adds up the work of all tasks; returns true once that is over the budget.
  bool exhausted() {
    if (work - reported >= 4096) report();
    return total.load(std::memory_order_relaxed) > budget;
  }
  void report() {
    total.fetch_add(work - reported, std::memory_order_relaxed);
    reported = work;
  }

  // Compares all groups under both nodes; the instruction set is chosen at run time.
  void run(std::uint32_t level, std::uint32_t a, std::uint32_t b);
};

namespace {

using Walk = BroadPhaseWalk;
using Boxes8 = BroadPhaseWalk::Boxes8;
using Ids8 = BroadPhaseWalk::Ids8;

#if defined(__x86_64__)

namespace avx2 {
#define VT_TARGET __attribute__((target("avx2")))
VT_TARGET static inline unsigned overlap8(const Boxes8& b, const Box1& q) {
  __m256 apart = _mm256_setzero_ps();
  for (int k = 0; k < 3; ++k) {
    apart = _mm256_or_ps(apart, _mm256_cmp_ps(_mm256_load_ps(b.lo[k]), _mm256_set1_ps(q.hi[k]), _CMP_GT_OQ));
    apart = _mm256_or_ps(apart, _mm256_cmp_ps(_mm256_load_ps(b.hi[k]), _mm256_set1_ps(q.lo[k]), _CMP_LT_OQ));
  }
  return ~static_cast<unsigned>(_mm256_movemask_ps(apart)) & 0xffu;
}
VT_TARGET static inline unsigned shared8(const Ids8& b, const Ids8& a, unsigned k) {
  __m256i same = _mm256_setzero_si256();
  for (int i = 0; i < 3; ++i) {
    if (a.id[i][k] == kNone) continue;
    const __m256i v = _mm256_set1_epi32(static_cast<int>(a.id[i][k]));
    for (int j = 0; j < 3; ++j)
      same = _mm256_or_si256(
          same, _mm256_cmpeq_epi32(v, _mm256_load_si256(reinterpret_cast<const __m256i*>(b.id[j]))));
  }
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(same)));
}
#include "solids/polyhedron/broad_phase_walk.inc"
#undef VT_TARGET
}  // namespace avx2

namespace baseline {
#define VT_TARGET
static inline unsigned overlap4(const Boxes8& b, const Box1& q, int h) {
  __m128 apart = _mm_setzero_ps();
  for (int k = 0; k < 3; ++k) {
    apart = _mm_or_ps(apart, _mm_cmpgt_ps(_mm_load_ps(b.lo[k] + h), _mm_set1_ps(q.hi[k])));
    apart = _mm_or_ps(apart, _mm_cmplt_ps(_mm_load_ps(b.hi[k] + h), _mm_set1_ps(q.lo[k])));
  }
  return ~static_cast<unsigned>(_mm_movemask_ps(apart)) & 0xfu;
}
static inline unsigned overlap8(const Boxes8& b, const Box1& q) {
  return overlap4(b, q, 0) | overlap4(b, q, 4) << 4;
}
static inline unsigned shared4(const Ids8& b, const Ids8& a, unsigned k, int h) {
  __m128i same = _mm_setzero_si128();
  for (int i = 0; i < 3; ++i) {
    if (a.id[i][k] == kNone) continue;
    const __m128i v = _mm_set1_epi32(static_cast<int>(a.id[i][k]));
    for (int j = 0; j < 3; ++j)
      same = _mm_or_si128(same,
                          _mm_cmpeq_epi32(v, _mm_load_si128(reinterpret_cast<const __m128i*>(b.id[j] + h))));
  }
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(same)));
}
static inline unsigned shared8(const Ids8& b, const Ids8& a, unsigned k) {
  return shared4(b, a, k, 0) | shared4(b, a, k, 4) << 4;
}
#include "solids/polyhedron/broad_phase_walk.inc"
#undef VT_TARGET
}  // namespace baseline

#else

namespace baseline {
#define VT_TARGET
static inline unsigned overlap8(const Boxes8& b, const Box1& q) {
  unsigned out = 0;
  for (unsigned i = 0; i < 8; ++i) {
    bool apart = false;
    for (int k = 0; k < 3; ++k) apart |= b.lo[k][i] > q.hi[k] || b.hi[k][i] < q.lo[k];
    out |= static_cast<unsigned>(!apart) << i;
  }
  return out;
}
static inline unsigned shared8(const Ids8& b, const Ids8& a, unsigned k) {
  unsigned out = 0;
  for (unsigned i = 0; i < 8; ++i)
    for (int m = 0; m < 3; ++m)
      for (int j = 0; j < 3; ++j)
        out |= static_cast<unsigned>(a.id[m][k] != kNone && a.id[m][k] == b.id[j][i]) << i;
  return out;
}
#include "solids/polyhedron/broad_phase_walk.inc"
#undef VT_TARGET
}  // namespace baseline

#endif

}  // namespace

void internal::use_baseline_boxes(bool only_baseline) { only_baseline_boxes.store(only_baseline); }

void BroadPhaseWalk::run(std::uint32_t level, std::uint32_t a, std::uint32_t b) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2 && !only_baseline_boxes.load(std::memory_order_relaxed))
    a == b ? avx2::self(*this, level, a) : avx2::cross(*this, level, a, b);
  else
#endif
    a == b ? baseline::self(*this, level, a) : baseline::cross(*this, level, a, b);
  report();
  flush();
}

BoxGroups::BoxGroups(const TriangleMesh& mesh, std::vector<std::uint32_t> order, const VertexStars& stars,
                     const UnitScale& scale, unsigned jobs)
    : scale_(scale), order_(std::move(order)) {
  VT_CHECK(order_.size() < (std::size_t{1} << 30), "too many facets");
  if (order_.empty()) return;
  build_groups(mesh, stars, jobs);
  build_levels(jobs);
  plan_tasks();
}

void BoxGroups::build_groups(const TriangleMesh& mesh, const VertexStars& stars, unsigned jobs) {
  const std::size_t groups = num_chunks(order_.size(), 8);
  levels_.emplace_back(groups);
  ids_ = Buffer<Ids8>(groups);
  parallel_for(groups, 1 << 11, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      Boxes8& boxes = levels_[0][g];
      Ids8& ids = ids_[g];
      for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t at = 8 * g + i;
        float lo[3] = {kInf, kInf, kInf}, hi[3] = {-kInf, -kInf, -kInf};
        for (std::size_t k = 0; k < 3; ++k) {
          ids.id[k][i] = kNone;
          if (at >= order_.size()) continue;
          const std::uint32_t v = mesh.faces[order_[at]][k];
          if (stars[v]) ids.id[k][i] = v;
          const Vec3d& p = mesh.positions[v];
          const float c[3] = {scale_.x(p.x), scale_.y(p.y), scale_.z(p.z)};
          for (int m = 0; m < 3; ++m) {
            lo[m] = std::min(lo[m], c[m]);
            hi[m] = std::max(hi[m], c[m]);
          }
        }
        for (int m = 0; m < 3; ++m) {
          boxes.lo[m][i] = lo[m];
          boxes.hi[m][i] = hi[m];
        }
      }
    }
  });
}

void BoxGroups::build_levels(unsigned jobs) {
  while (levels_.back().size() > 1) {
    const Buffer<Boxes8>& below = levels_.back();
    Buffer<Boxes8> level(num_chunks(below.size(), 8));
    parallel_for(level.size(), 1 << 11, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g)
        for (std::size_t i = 0; i < 8; ++i)
          for (int m = 0; m < 3; ++m) {
            float lo = kInf, hi = -kInf;
            if (8 * g + i < below.size())
              for (std::size_t k = 0; k < 8; ++k) {
                lo = std::min(lo, below[8 * g + i].lo[m][k]);
                hi = std::max(hi, below[8 * g + i].hi[m][k]);
              }
            level[g].lo[m][i] = lo;
            level[g].hi[m][i] = hi;
          }
    });
    levels_.push_back(std::move(level));
  }
}

// Splits the root into independent pairs of nodes, level by level, until there are enough.
void BoxGroups::plan_tasks() {
  tasks_ = {{static_cast<std::uint32_t>(levels_.size() - 1), 0, 0}};
  while (tasks_.size() < kTaskGoal && tasks_[0].level > 0) {
    std::vector<Task> finer;
    for (const Task& t : tasks_) {
      const Boxes8 &a = levels_[t.level][t.a], &b = levels_[t.level][t.b];
      const auto below = static_cast<std::uint32_t>(levels_[t.level - 1].size());
      for (std::uint32_t i = 0; i < 8 && 8 * t.a + i < below; ++i)
        for (std::uint32_t j = t.a == t.b ? i : 0; j < 8 && 8 * t.b + j < below; ++j) {
          bool apart = false;
          for (int m = 0; m < 3; ++m) apart |= a.lo[m][i] > b.hi[m][j] || b.lo[m][j] > a.hi[m][i];
          if (!apart) finer.push_back({t.level - 1, 8 * t.a + i, 8 * t.b + j});
        }
    }
    tasks_ = std::move(finer);
  }
}

bool BoxGroups::for_each_overlap(std::uint64_t budget, unsigned jobs, const Sink& sink,
                                 WorkShare* work) const {
  std::atomic<std::uint64_t> total{0};
  WorkStep step(work, static_cast<double>(tasks_.size()));
  parallel_for(tasks_.size(), 1, jobs, [&](std::size_t task, std::size_t, std::size_t) {
    Walk walk{levels_, ids_, order_, sink, task, total, budget, 0, 0, {}};
    if (walk.exhausted()) return;
    walk.run(tasks_[task].level, tasks_[task].a, tasks_[task].b);
    step.add(1);
  });
  return total.load() <= budget;
}

bool BoxGroups::stabbed(const Vec3d& from, int axis, bool positive, std::size_t most,
                        std::vector<std::uint32_t>& out) const {
  if (order_.empty()) return true;
  const float at[3] = {scale_.x(from.x), scale_.y(from.y), scale_.z(from.z)};
  float lo[3] = {at[0], at[1], at[2]}, hi[3] = {at[0], at[1], at[2]};
  (positive ? hi : lo)[axis] = positive ? kInf : -kInf;
  return stab(levels_.size() - 1, 0, lo, hi, most, out);
}

// Depth is at most log8 of the number of facets.
bool BoxGroups::stab(std::size_t level, std::size_t node, const float (&lo)[3], const float (&hi)[3],
                     std::size_t most, std::vector<std::uint32_t>& out) const {
  const Boxes8& b = levels_[level][node];
  for (std::size_t i = 0; i < 8; ++i) {
    bool apart = false;
    for (int m = 0; m < 3; ++m) apart |= b.lo[m][i] > hi[m] || b.hi[m][i] < lo[m];
    if (apart) continue;
    if (level == 0) {
      if (out.size() == most) return false;
      out.push_back(order_[8 * node + i]);
    } else if (!stab(level - 1, 8 * node + i, lo, hi, most, out)) {
      return false;
    }
  }
  return true;
}

}  // namespace veritope
