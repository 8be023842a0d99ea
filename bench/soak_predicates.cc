// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_predicates.cc: --cases N --seed S [--jobs J]. Signs of orient2d, orient3d, in_circle and in_sphere, with
// and without a session, compared with an oracle of this file's own: mpz integers on one common exponent, expanded
// relative to another point than the subject uses. One case in 4096 is checked a third time, by Gaussian elimination of
// the homogeneous determinant over mpq. One JSON line a figure.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/session.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "robust/base/random.h"

namespace {

using veritope::Random;
using veritope::Sign;
using veritope::TierCounts;
using veritope::Vec2d;
using veritope::Vec3d;

enum Predicate { kOrient2d, kOrient3d, kInCircle, kInSphere, kNumPredicates };
enum Class { kGeneric, kNear, kDegenerate, kExtreme, kNumClasses };
constexpr const char* kPredicateNames[] = {"orient2d", "orient3d", "in_circle", "in_sphere"};
constexpr const char* kClassNames[] = {"generic", "near_degenerate", "degenerate",
                                       "extreme_exponents"};
constexpr int kNumPoints[] = {3, 4, 4, 5};

using Points = std::array<std::array<double, 3>, 5>;

// ---- oracle
// -----------------------------------------------------------------------------------------------------------

class Oracle {
 public:
  Oracle() {
    for (auto& row : m_) {
      for (auto& v : row) mpz_init2(v, 512);
    }
    for (auto& v : t_) mpz_init2(v, 1024);
  }
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;
  ~Oracle() {
    for (auto& row : m_) {
      for (auto& v : row) mpz_clear(v);
    }
    for (auto& v : t_) mpz_clear(v);
  }

  int sign(Predicate predicate, const Points& p) {
    const int dim = predicate == kOrient2d || predicate == kInCircle ? 2 : 3,
              n = kNumPoints[predicate];
    load(p, n, dim);
    // Differences from another point than the subject's: the last for orientations, the first for
    // circles and spheres.
    const int base = predicate == kOrient2d || predicate == kOrient3d ? n - 1 : 0;
    int row = 0;
    for (int i = 0; i < n; ++i) {
      if (i == base) continue;
      for (int k = 0; k < dim; ++k) mpz_sub(m_[row][k], m_[i + kRaw][k], m_[base + kRaw][k]);
      ++row;
    }
    if (predicate == kOrient2d) return det2(0, 1);
    if (predicate == kOrient3d)
      return -det3();  // det(b - a, c - a, d - a) = -det(a - d, b - d, c - d)
    for (int i = 0; i < row; ++i) {
      mpz_mul(m_[i][dim], m_[i][0], m_[i][0]);
      for (int k = 1; k < dim; ++k) mpz_addmul(m_[i][dim], m_[i][k], m_[i][k]);
    }
    // Subtracting the first row of the homogeneous determinant (ones last) leaves (-1)^(n + 1)
    // times the minor without it; in_circle is that determinant, in_sphere its negative.
    return predicate == kInCircle ? -det3() : -det4();
  }

 private:
  static constexpr int kRaw = 4;  // rows 4..8 hold the coordinates, rows 0..3 the differences

  void load(const Points& p, int n, int dim) {
    std::array<std::array<int, 3>, 5> exponent;
    int least = std::numeric_limits<int>::max();
    std::array<std::array<std::int64_t, 3>, 5> mantissa;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < dim; ++k) {
        int e;
        mantissa[i][k] = static_cast<std::int64_t>(std::ldexp(std::frexp(p[i][k], &e), 53));
        exponent[i][k] = e - 53;
        if (mantissa[i][k] != 0) least = std::min(least, exponent[i][k]);
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < dim; ++k) {
        mpz_set_si(m_[i + kRaw][k], mantissa[i][k]);
        if (mantissa[i][k] != 0) {
          mpz_mul_2exp(m_[i + kRaw][k], m_[i + kRaw][k],
                       static_cast<mp_bitcnt_t>(exponent[i][k] - least));
        }
      }
    }
  }
  int det2(int a, int b) {
    mpz_mul(t_[0], m_[a][0], m_[b][1]);
    mpz_submul(t_[0], m_[a][1], m_[b][0]);
    return mpz_sgn(t_[0]);
  }
  // The determinant of columns j0 < j1 < j2 of three rows, along the first column, into out.
  void det3_into(mpz_t out, int a, int b, int c, int j0, int j1, int j2) {
    const int rows[3][3] = {{a, b, c}, {b, c, a}, {c, a, b}};
    mpz_set_ui(out, 0);
    for (const auto& r : rows) {
      mpz_mul(t_[0], m_[r[1]][j1], m_[r[2]][j2]);
      mpz_submul(t_[0], m_[r[1]][j2], m_[r[2]][j1]);
      mpz_addmul(out, m_[r[0]][j0], t_[0]);
    }
  }
  int det3() {
    det3_into(t_[1], 0, 1, 2, 0, 1, 2);
    return mpz_sgn(t_[1]);
  }
  int det4() {
    // Along the last column: rows (0,1,2,3), cofactor signs - + - +.
    constexpr int kOthers[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
    mpz_set_ui(t_[2], 0);
    for (int i = 0; i < 4; ++i) {
      det3_into(t_[1], kOthers[i][0], kOthers[i][1], kOthers[i][2], 0, 1, 2);
      if (i % 2 == 0) {
        mpz_submul(t_[2], m_[i][3], t_[1]);
      } else {
        mpz_addmul(t_[2], m_[i][3], t_[1]);
      }
    }
    return mpz_sgn(t_[2]);
  }

  mpz_t m_[9][4];
  mpz_t t_[3];
};

// The definition: the sign of the homogeneous determinant, by elimination.
int slow_sign(Predicate predicate, const Points& p) {
  const int dim = predicate == kOrient2d || predicate == kInCircle ? 2 : 3;
  const bool lifted = predicate == kInCircle || predicate == kInSphere;
  std::vector<std::vector<mpq_class>> m;
  for (int i = 0; i < kNumPoints[predicate]; ++i) {
    std::vector<mpq_class> row{1};
    mpq_class lift = 0;
    for (int k = 0; k < dim; ++k) {
      row.emplace_back(p[i][k]);
      lift += row.back() * row.back();
    }
    if (lifted) row.push_back(lift);
    m.push_back(row);
  }
  int sign = lifted ? -1 : 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < m.size() && sgn(m[pivot][k]) == 0) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != k) std::swap(m[pivot], m[k]), sign = -sign;
    sign *= sgn(m[k][k]);
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const mpq_class factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return sign;
}

// ---- inputs
// -----------------------------------------------------------------------------------------------------------

double finite_bits(Random& random) {
  for (;;) {
    const std::uint64_t bits = random.next();
    double v;
    std::memcpy(&v, &bits, sizeof v);
    if (std::isfinite(v)) return v;
  }
}

template <typename Draw>
Points filled(Draw draw) {
  Points p;
  for (auto& point : p) {
    for (double& c : point) c = draw();
  }
  return p;
}

// On a line or plane; integers of up to 2 b + 1 bits.
Points flat(Predicate predicate, Random& random) {
  const std::int64_t range = std::int64_t{1} << random.between(1, 24);
  std::array<std::int64_t, 3> o, u, v;
  for (int k = 0; k < 3; ++k) {
    o[k] = random.between(-range, range) * range;
    u[k] = random.between(-range, range);
    v[k] = predicate == kOrient2d ? 0 : random.between(-range, range);
  }
  Points p;
  for (auto& point : p) {
    const std::int64_t s = random.between(-range, range), t = random.between(-range, range);
    for (int k = 0; k < 3; ++k) point[k] = static_cast<double>(o[k] + s * u[k] + t * v[k]);
  }
  return p;
}

// On a circle: products of Gaussian integers, each taken as itself or conjugated, and turned by a
// unit, have one norm.
Points on_circle(Random& random) {
  const std::int64_t range = std::int64_t{1} << random.between(1, 5);
  const int factors = static_cast<int>(random.between(1, 4));
  std::array<std::array<std::int64_t, 2>, 4> g;
  for (auto& z : g) z = {random.between(1, range), random.between(1, range)};
  const std::int64_t far = std::int64_t{1} << random.between(0, 48);
  const std::int64_t cx = random.between(-far, far), cy = random.between(-far, far);
  Points p{};
  for (auto& point : p) {
    std::int64_t x = 1, y = 0;
    for (int f = 0; f < factors; ++f) {
      const std::int64_t a = g[f][0], b = random.below(2) == 0 ? g[f][1] : -g[f][1];
      const std::int64_t nx = x * a - y * b;
      y = x * b + y * a, x = nx;
    }
    for (std::uint64_t turn = random.below(4); turn > 0; --turn) {
      const std::int64_t nx = -y;
      y = x, x = nx;
    }
    point[0] = static_cast<double>(cx + x), point[1] = static_cast<double>(cy + y);
  }
  return p;
}

// On a sphere: one integer vector, its coordinates permuted and negated, rotated by a quaternion
// (times its norm).
Points on_sphere(Random& random) {
  const std::int64_t range = std::int64_t{1} << random.between(1, 10),
                     small = random.between(0, 40);
  const std::array<std::int64_t, 3> v{random.between(0, range), random.between(0, range),
                                      random.between(0, range)};
  const std::int64_t a = random.between(1, 40), b = random.between(-small, small),
                     c = random.between(-small, small), d = random.between(-small, small);
  const std::int64_t rotation[3][3] = {
      {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
      {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
      {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  const std::int64_t far = std::int64_t{1} << random.between(0, 48);
  const std::array<std::int64_t, 3> centre{random.between(-far, far), random.between(-far, far),
                                           random.between(-far, far)};
  Points p;
  for (auto& point : p) {
    std::array<std::int64_t, 3> w = v;
    std::swap(w[0], w[random.below(3)]);
    std::swap(w[1], w[1 + random.below(2)]);
    for (std::int64_t& x : w) x = random.below(2) == 0 ? x : -x;
    for (int k = 0; k < 3; ++k) {
      point[k] = static_cast<double>(centre[k] + rotation[k][0] * w[0] + rotation[k][1] * w[1] +
                                     rotation[k][2] * w[2]);
    }
  }
  return p;
}

// Real coordinates that are nevertheless exactly degenerate: faces along an axis, corners of a box.
Points along_axes(Predicate predicate, Random& random) {
  Points p = filled([&] { return random.unit(); });
  if (predicate == kOrient2d || predicate == kOrient3d) {
    const std::uint64_t axis = random.below(predicate == kOrient2d ? 2 : 3);
    for (auto& point : p) point[axis] = p[0][axis];
  } else {
    // Corners of a box with dyadic half sizes: the two values of a coordinate are centre +- half
    // exactly.
    std::array<double, 3> centre, half;
    for (int k = 0; k < 3; ++k) {
      centre[k] = std::ldexp(static_cast<double>(random.between(0, std::int64_t{1} << 50)), -50);
      half[k] = std::ldexp(static_cast<double>(random.between(0, std::int64_t{1} << 50)), -50);
    }
    for (auto& point : p) {
      for (int k = 0; k < 3; ++k)
        point[k] = random.below(2) == 0 ? centre[k] + half[k] : centre[k] - half[k];
    }
  }
  return p;
}

Points degenerate(Predicate predicate, Random& random) {
  Points p;
  const std::uint64_t kind = random.below(16);
  if (kind == 0) {  // a point twice
    p = filled([&] { return finite_bits(random); });
    const int n = kNumPoints[predicate];
    const std::uint64_t i = random.below(static_cast<std::uint64_t>(n));
    p[i] = p[(i + 1) % static_cast<std::uint64_t>(n)];
    return p;
  }
  if (kind <= 3) {
    p = along_axes(predicate, random);
  } else {
    p = predicate == kInCircle
            ? on_circle(random)
            : (predicate == kInSphere ? on_sphere(random) : flat(predicate, random));
  }
  const int scale = static_cast<int>(random.between(-60, 60));
  for (auto& point : p) {
    for (double& c : point) c = std::ldexp(c, scale);
  }
  return p;
}

void nudge(double& v, Random& random) {
  for (std::int64_t steps = random.between(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1) {
    v = std::nextafter(v, steps > 0 ? 1e308 : -1e308);
  }
}

Points extreme(Predicate predicate, Random& random) {
  switch (random.below(6)) {
    case 0: return filled([&] { return finite_bits(random); });
    case 1: return filled([&] { return static_cast<double>(random.between(-5, 5)) * 0x1p-1074; });
    case 2: {  // exponents spread a little, full mantissas
      const int spread = static_cast<int>(random.between(1, 120));
      return filled([&] {
        return std::ldexp(random.unit() - 0.5, static_cast<int>(random.between(-spread, 0)));
      });
    }
    case 3: {
      constexpr double kBase[] = {0.0,       -0.0, 1.0,     0x1p-1074, 0x1.fffffffffffffp1023,
                                  0x1p-1022, 3.0,  0x1p511, 0x1p-537};
      return filled([&] {
        double v = kBase[random.below(9)];
        nudge(v, random);
        if (!std::isfinite(v)) v = 0x1.fffffffffffffp1023;
        return random.below(2) == 0 ? v : -v;
      });
    }
    case 4: {  // where determinants of this degree, or their parts, overflow or underflow
      constexpr int kDegrees[] = {2, 3, 4, 5};
      constexpr int kLimits[] = {1024, -900, -960, -1074};
      const int exponent =
          kLimits[random.below(4)] / kDegrees[predicate] + static_cast<int>(random.between(-1, 2));
      return filled([&] { return std::ldexp(random.unit() - 0.5, exponent); });
    }
    default: {
      Points p = degenerate(predicate, random);
      const int scale = static_cast<int>(random.between(-960, 890));
      for (auto& point : p) {
        for (double& c : point) {
          const double scaled = std::ldexp(c, scale);
          c = std::isfinite(scaled) ? scaled : c;
        }
      }
      return p;
    }
  }
}

Points drawn(Predicate predicate, Class kind, Random& random) {
  switch (kind) {
    case kGeneric: return filled([&] { return random.unit(); });
    case kDegenerate: return degenerate(predicate, random);
    case kExtreme: return extreme(predicate, random);
    default: break;
  }
  Points p = degenerate(predicate, random);
  for (auto& point : p) {
    for (double& c : point) nudge(c, random);
  }
  return p;
}

// ---- run
// --------------------------------------------------------------------------------------------------------------

Sign subject(Predicate predicate, const Points& p, TierCounts* tally) {
  const auto flat_point = [&](int i) { return Vec2d{p[i][0], p[i][1]}; };
  const auto point = [&](int i) { return Vec3d{p[i][0], p[i][1], p[i][2]}; };
  switch (predicate) {
    case kOrient2d: return veritope::orient2d(flat_point(0), flat_point(1), flat_point(2), tally);
    case kOrient3d: return veritope::orient3d(point(0), point(1), point(2), point(3), tally);
    case kInCircle:
      return veritope::in_circle(flat_point(0), flat_point(1), flat_point(2), flat_point(3), tally);
    default: return veritope::in_sphere(point(0), point(1), point(2), point(3), point(4), tally);
  }
}

struct Counts {
  std::array<std::array<std::uint64_t, kNumClasses>, kNumPredicates> cases{}, zeros{}, wrong{};
  std::array<TierCounts, kNumPredicates> tiers;
  std::uint64_t oracle_faults = 0;

  void operator+=(const Counts& o) {
    for (int p = 0; p < kNumPredicates; ++p) {
      for (int k = 0; k < kNumClasses; ++k) {
        cases[p][k] += o.cases[p][k], zeros[p][k] += o.zeros[p][k], wrong[p][k] += o.wrong[p][k];
      }
      tiers[p] += o.tiers[p];
    }
    oracle_faults += o.oracle_faults;
  }
};

void report_wrong(Predicate predicate, Class kind, const Points& p, int got, int expected) {
  std::string text = std::string(kPredicateNames[predicate]) + " " + kClassNames[kind] + ":";
  for (int i = 0; i < kNumPoints[predicate]; ++i) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, " {%a, %a, %a}", p[i][0], p[i][1], p[i][2]);
    text += buffer;
  }
  std::fprintf(stderr, "%s: %d, expected %d\n", text.c_str(), got, expected);
}

// Decides in a session of the tuple's own box.
Sign subject_in_session(Predicate predicate, const Points& p) {
  std::array<Vec3d, 5> v;
  std::array<Vec2d, 5> w;
  const int n = kNumPoints[predicate];
  for (int i = 0; i < n; ++i) v[i] = {p[i][0], p[i][1], p[i][2]}, w[i] = {p[i][0], p[i][1]};
  if (predicate == kOrient2d || predicate == kInCircle) {
    const auto session = veritope::Session2d::around(w.data(), static_cast<std::size_t>(n));
    return predicate == kOrient2d ? session.orient2d(w[0], w[1], w[2])
                                  : session.in_circle(w[0], w[1], w[2], w[3]);
  }
  const auto session = veritope::Session3d::around(v.data(), static_cast<std::size_t>(n));
  return predicate == kOrient3d ? session.orient3d(v[0], v[1], v[2], v[3])
                                : session.in_sphere(v[0], v[1], v[2], v[3], v[4]);
}

Counts run_chunk(std::uint64_t seed, std::size_t begin, std::size_t end) {
  thread_local Oracle oracle;
  Random random(seed);
  Counts counts;
  for (std::size_t i = begin; i < end; ++i) {
    const Predicate predicate = static_cast<Predicate>(i % kNumPredicates);
    const std::uint64_t lot = random.below(100);  // 20 generic, 20 near, 45 degenerate, 15 extreme
    const Class kind =
        lot < 20 ? kGeneric : (lot < 40 ? kNear : (lot < 85 ? kDegenerate : kExtreme));
    const Points p = drawn(predicate, kind, random);
    const int got = to_int(subject(predicate, p, &counts.tiers[predicate])),
              expected = oracle.sign(predicate, p);
    ++counts.cases[predicate][kind];
    if (expected == 0) ++counts.zeros[predicate][kind];
    const int in_session = to_int(subject_in_session(predicate, p));
    if ((got != expected || in_session != expected) && counts.wrong[predicate][kind]++ == 0)
      report_wrong(predicate, kind, p, got != expected ? got : in_session, expected);
    if (random.below(4096) == 0 && slow_sign(predicate, p) != expected) ++counts.oracle_faults;
  }
  return counts;
}

void figure(const std::string& command, const std::string& name, double value,
            const std::string& goal) {
  std::printf("{\"name\":\"%s\",\"value\":%.17g,\"goal\":\"%s\",\"command\":\"%s\"}\n",
              name.c_str(), value, goal.c_str(), command.c_str());
}

// Prints the figures; returns the number of wrong signs.
std::uint64_t report_figures(const Counts& total, std::uint64_t cases, const std::string& command) {
  std::uint64_t wrong = 0, zeros = 0;
  const auto sum_class = [&](const auto& table, int k) {
    std::uint64_t sum = 0;
    for (int p = 0; p < kNumPredicates; ++p) sum += table[p][k];
    return sum;
  };
  for (int k = 0; k < kNumClasses; ++k)
    wrong += sum_class(total.wrong, k), zeros += sum_class(total.zeros, k);
  figure(command, "predicates_cases", static_cast<double>(cases), ">= 1e8");
  figure(command, "predicates_wrong_signs", static_cast<double>(wrong), "0");
  figure(command, "predicates_oracle_faults", static_cast<double>(total.oracle_faults), "0");
  figure(command, "predicates_exact_zeros_fraction",
         static_cast<double>(zeros) / static_cast<double>(cases), ">= 0.3");
  for (int k = 0; k < kNumClasses; ++k) {
    const double n = static_cast<double>(sum_class(total.cases, k));
    figure(command, std::string("predicates_") + kClassNames[k] + "_cases", n, "reported");
    figure(command, std::string("predicates_") + kClassNames[k] + "_zeros_fraction",
           n > 0 ? static_cast<double>(sum_class(total.zeros, k)) / n : 0,
           k == kDegenerate ? ">= 0.3" : "reported");
  }
  constexpr const char* kTierNames[] = {"filter", "lattice", "interval", "exact"};
  for (int p = 0; p < kNumPredicates; ++p) {
    for (std::size_t t = 0; t < veritope::kNumTiers; ++t) {
      figure(command,
             std::string("predicates_") + kPredicateNames[p] + "_decided_by_" + kTierNames[t],
             static_cast<double>(total.tiers[p].decided[t]), "reported");
    }
  }
  return wrong;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cases = 100000000, seed = 1;
  unsigned jobs = 2;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc || (name != "--cases" && name != "--seed" && name != "--jobs")) {
      std::fprintf(stderr, "usage: soak_predicates [--cases N] [--seed S] [--jobs J]\n");
      return 2;
    }
    const std::uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (name == "--cases") cases = value;
    if (name == "--seed") seed = value;
    if (name == "--jobs") jobs = static_cast<unsigned>(value);
  }
  if (const veritope::Status status = veritope::check_fp(); !status) {
    std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
    return 5;
  }
  const std::string command =
      "soak_predicates --cases " + std::to_string(cases) + " --seed " + std::to_string(seed);
  const auto start = std::chrono::steady_clock::now();
  constexpr std::size_t kChunk = 100000;
  std::vector<Counts> parts(veritope::num_chunks(cases, kChunk));
  veritope::parallel_for(cases, kChunk, jobs,
                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                           parts[chunk] = run_chunk(seed * 0x9e3779b97f4a7c15u + chunk, begin, end);
                         });
  Counts total;
  for (const Counts& part : parts) total += part;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::uint64_t wrong = report_figures(total, cases, command);
  figure(command, "predicates_seconds", seconds, "<= 600");
  return wrong == 0 && total.oracle_faults == 0 ? 0 : 1;
}
