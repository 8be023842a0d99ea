// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_implicit.cc: --cases N --seed S [--jobs J]. Every predicate on points of every kind is compared with the
// points themselves in GMP's rationals, found by Cramer's rule, and determinants of them by elimination. Half of the
// cases are in space, half in the plane; a case is five points and tests all predicates. The perturbed predicates must
// give no zero, the plain sign where there is one, and be antisymmetric. One JSON line a figure.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "predicates/perturbed.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "tests/predicates/implicit_judge.h"

namespace {

using namespace veritope;

struct Counts {
  std::uint64_t cases = 0, signs = 0, zeros = 0, missing = 0, wrong = 0;
  std::map<std::string, std::array<std::uint64_t, 3>> predicates;  // signs, zeros, wrong
  TierCounts tiers;
};

class Judge {
 public:
  Judge(std::uint64_t seed, Counts& counts) : random_(seed), seed_(seed), counts_(counts) {}

  void run_case(std::size_t number) {
    const int dimension = number % 2 == 0 ? 3 : 2;
    std::string text;
    bool agrees = true;
    const bool exist =
        judge::ask(random_, dimension, text, agrees, &counts_.tiers, [&](const judge::Question& q) {
          count(q.name, to_int(q.found) == q.expected, q.expected == 0, number, text);
        });
    ++counts_.cases;
    counts_.missing += !exist;
    if (!agrees) count("is_defined", false, false, number, text);
    if (number % 2 == 0) perturb(number);
  }

 private:
  void count(const std::string& name, bool right, bool zero, std::size_t number,
             const std::string& text) {
    auto& [signs, zeros, wrong] = counts_.predicates[name];
    ++signs, ++counts_.signs;
    zeros += zero, counts_.zeros += zero;
    if (right) return;
    ++wrong;
    if (counts_.wrong++ == 0) {
      std::fprintf(stderr, "wrong: %s seed %llu number %zu: %s\n", name.c_str(),
                   static_cast<unsigned long long>(seed_), number, text.c_str());
    }
  }

  void perturb(std::size_t number) {
    const auto kind = static_cast<generate::Kind>(random_.below(generate::kNumKinds));
    const generate::Points p = generate::points(kind, random_);
    std::array<PointId, 5> id{};
    for (std::size_t i = 0; i < 5; ++i) id[i] = random_.next() << 3 | i;
    using generate::xy;
    const std::string text = generate::text(p);
    const auto judged = [&](const char* name, Sign first, Sign swapped, int plain) {
      const bool right =
          first != Sign::kZero && swapped == -first && (plain == 0 || to_int(first) == plain);
      count(name, right, plain == 0, number, text);
    };
    using oracle::exact;
    judged("orient2d_perturbed",
           orient2d_perturbed({xy(p[0]), xy(p[1]), xy(p[2])}, {id[0], id[1], id[2]}),
           orient2d_perturbed({xy(p[0]), xy(p[2]), xy(p[1])}, {id[0], id[2], id[1]}),
           oracle::orient({exact(xy(p[0])), exact(xy(p[1])), exact(xy(p[2]))}));
    judged("orient3d_perturbed",
           orient3d_perturbed({p[0], p[1], p[2], p[3]}, {id[0], id[1], id[2], id[3]}),
           orient3d_perturbed({p[3], p[1], p[2], p[0]}, {id[3], id[1], id[2], id[0]}),
           oracle::orient({exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3])}));
    judged(
        "in_circle_perturbed",
        in_circle_perturbed({xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])}, {id[0], id[1], id[2], id[3]}),
        in_circle_perturbed({xy(p[1]), xy(p[0]), xy(p[2]), xy(p[3])}, {id[1], id[0], id[2], id[3]}),
        oracle::in_ball({exact(xy(p[0])), exact(xy(p[1])), exact(xy(p[2])), exact(xy(p[3]))}));
    judged("in_sphere_perturbed", in_sphere_perturbed(p, id),
           in_sphere_perturbed({p[0], p[4], p[2], p[3], p[1]}, {id[0], id[4], id[2], id[3], id[1]}),
           oracle::in_ball({exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]), exact(p[4])}));
  }

  Random random_;
  std::uint64_t seed_;
  Counts& counts_;
};

void figure(const std::string& name, double value, const std::string& goal) {
  std::printf("{\"name\":\"%s\",\"value\":%.17g,\"goal\":\"%s\"}\n", name.c_str(), value,
              goal.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cases = 1000000, seed = 1;
  unsigned jobs = 2;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc || (name != "--cases" && name != "--seed" && name != "--jobs")) {
      std::fprintf(stderr, "usage: soak_implicit [--cases N] [--seed S] [--jobs J]\n");
      return 2;
    }
    const std::uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (name == "--cases") cases = value;
    if (name == "--seed") seed = value;
    if (name == "--jobs") jobs = static_cast<unsigned>(value);
  }
  if (const Status status = check_fp(); !status) {
    std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
    return 5;
  }
  constexpr std::size_t kChunk = 5000;
  std::vector<Counts> parts(num_chunks(cases, kChunk));
  parallel_for(cases, kChunk, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Judge judge(seed * 0x9e3779b97f4a7c15u + chunk, parts[chunk]);
    for (std::size_t i = begin; i < end; ++i) judge.run_case(i);
  });
  Counts total;
  for (const Counts& part : parts) {
    total.cases += part.cases, total.signs += part.signs, total.zeros += part.zeros;
    total.missing += part.missing, total.wrong += part.wrong, total.tiers += part.tiers;
    for (const auto& [name, counts] : part.predicates) {
      for (std::size_t i = 0; i < 3; ++i) total.predicates[name][i] += counts[i];
    }
  }
  figure("implicit_cases", static_cast<double>(total.cases), ">= 1e6");
  figure("implicit_signs", static_cast<double>(total.signs), ">= 1e6 of each predicate");
  figure("implicit_wrong_signs", static_cast<double>(total.wrong), "0");
  figure("implicit_zeros_fraction",
         static_cast<double>(total.zeros) / static_cast<double>(total.signs), ">= 0.3");
  figure("implicit_undefined_fraction",
         static_cast<double>(total.missing) / static_cast<double>(total.cases), "reported");
  for (const auto& [name, counts] : total.predicates) {
    std::printf(
        "{\"name\":\"implicit_signs_of_%s\",\"value\":%llu,\"zeros\":%llu,\"wrong\":%llu,\"goal\":"
        "\"0 wrong\"}\n",
        name.c_str(), static_cast<unsigned long long>(counts[0]),
        static_cast<unsigned long long>(counts[1]), static_cast<unsigned long long>(counts[2]));
  }
  constexpr const char* kTierNames[] = {"filter", "lattice", "interval", "exact"};
  for (std::size_t t = 0; t < kNumTiers; ++t) {
    figure(std::string("implicit_decided_by_") + kTierNames[t],
           static_cast<double>(total.tiers.decided[t]), "reported");
  }
  return total.wrong == 0 ? 0 : 1;
}
