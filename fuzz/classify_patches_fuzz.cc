// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/classify_patches_fuzz.cc: points with respect to a small patch model, changed as the bytes say, valid or not:
// rays in all six directions, in doubles and in integers, the look-up, the values of boxes and the normal chain agree.
// A byte for the shape, four for each change; then 0xff, and four for each point.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "fuzz/pulled_patches.h"
#include "solids/chain/normal_chain.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_rays.h"

namespace veritope::fuzz {
namespace {

[[noreturn]] void fail(const char* what, const ExactPoint& p) {
  std::fprintf(stderr, "%s at %s %s %s\n", what, p[0].to_string().c_str(), p[1].to_string().c_str(),
               p[2].to_string().c_str());
  std::abort();
}

int sum_of(const ShellWindings& windings) {
  int out = 0;
  for (const auto& [shell, winding] : windings) out += winding;
  return out;
}

// A lattice point, or a control point, moved by little or not at all.
ExactPoint point_of(const PatchComplex& complex, const std::uint8_t* b) {
  ExactPoint out;
  if (b[0] % 2 == 0) {
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = Rational(static_cast<std::int8_t>(b[1 + k])) / Rational(48);
    return out;
  }
  const Patch& patch = complex.patch(b[1] % static_cast<std::uint32_t>(complex.patches().size()));
  const std::size_t i = b[2] % patch.num_control();
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = patch.component(static_cast<int>(k))[i];
    if (patch.is_rational()) out[k] /= patch.component(3)[i];
  }
  if (b[3] != 0)
    out[b[3] % 3] += Rational(b[3] % 2 == 0 ? 1 : -1) * Rational::power_of_two(-(b[3] / 4));
  return out;
}

class Agreement {
 public:
  explicit Agreement(const PatchComplex& complex)
      : rays_(complex), service_(PatchClassifier::make(complex, false, 3)), chain_(complex) {}

  void check(const ExactPoint& p) const {
    const RayPoint q(p, rays_.scale());
    std::optional<int> winding;
    const auto agree = [&](const RayCount& count) {
      if (count.state != RayCount::State::kCounted) return;
      if (winding && *winding != sum_of(count.windings)) fail("two rays differ", p);
      winding = sum_of(count.windings);
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool is_upward : {false, true}) {
        agree(rays_.count_rounded(q, {axis, is_upward}));
        agree(rays_.count_exactly(q, {axis, is_upward}, 24));
      }
    const PointAnswer answer = service_.classify(p);
    if (answer.is_decided && answer.is_on() && winding) fail("on, and counted", p);
    if (answer.is_decided && !answer.is_on() && winding && answer.winding != *winding)
      fail("the service differs from rays", p);
    const auto f = chain_.value(p, {Rational(1) / Rational(3), 0, Rational(1) / Rational(7)});
    if (f && winding && *f != *winding) fail("the normal chain differs from rays", p);
    Box3d box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = round_down(p[k]);
      box.hi[k] = round_up(p[k]) + 0x1p-20;
    }
    const Value3 value = service_.value(box);
    if (is_constant(value) && (!winding || (*winding != 0) != (value == Value3::kOne)))
      fail("the value of a box differs", p);
  }

 private:
  const PatchRays rays_;
  const PatchClassifier service_;
  const NormalChain chain_;
};

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope;
  using namespace veritope::fuzz;
  if (size == 0 || size > 61) return 0;
  Pulled model(shape(data[0]));
  std::size_t at = 1;
  for (; at + 4 <= size && data[at] != 0xff; at += 4) model.change(data + at);
  const auto complex = make_patch_complex(model.patches());
  if (!complex || !complex->is_closed_oriented_surface()) return 0;
  const Agreement agreement(*complex);
  for (++at; at + 4 <= size; at += 4) agreement.check(point_of(*complex, data + at));
  return 0;
}
