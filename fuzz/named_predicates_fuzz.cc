// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/named_predicates_fuzz.cc: a byte that names a predicate, then its operands. Every predicate of the command line,
// including generated ones and those on implicit points, is compared with its formula over rationals. The mutator draws
// hard cases and copies or moves single numbers.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "named_predicates/hard_cases.h"

namespace {

using namespace veritope;
using namespace veritope;

const std::vector<const NamedPredicate*>& predicates() {
  static const HardCases cases(1);
  return cases.predicates();
}

struct Input {
  std::uint8_t which = 0;
  Operands operands{};

  const NamedPredicate& predicate() const { return *predicates()[which % predicates().size()]; }
  static Input decode(const std::uint8_t* data, std::size_t size) {
    Input in;
    if (size == 0) return in;
    in.which = data[0];
    std::memcpy(in.operands.data(), data + 1, std::min(size - 1, sizeof in.operands));
    for (double& v : in.operands) {
      // Infinities and NaNs lose their top exponent bit.
      if (!std::isfinite(v))
        v = std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) & ~(std::uint64_t{1} << 62));
    }
    return in;
  }
  std::size_t encode(std::uint8_t* data, std::size_t max_size) const {
    const std::size_t bytes = predicate().num_operands * sizeof(double);
    if (max_size < bytes + 1) return 0;
    data[0] = which;
    std::memcpy(data + 1, operands.data(), bytes);
    return bytes + 1;
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Input in = Input::decode(data, size);
  const NamedPredicate& predicate = in.predicate();
  if (predicate.is_defined != nullptr && !predicate.is_defined(in.operands)) return 0;
  const Sign found = predicate.decide(in.operands, nullptr);
  const Sign exact = predicate.decide_by_formula(in.operands);
  if (found == exact) return 0;
  std::fprintf(stderr, "%s: expected %d, found %d:%s\n", std::string(predicate.name).c_str(),
               to_int(exact), to_int(found), operands_text({&predicate, in.operands}).c_str());
  std::abort();
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  Random random(seed);
  Input in = Input::decode(data, size);
  const std::size_t count = in.predicate().num_operands;
  const auto any = [&]() -> double& { return in.operands[random.below(count)]; };
  switch (random.below(6)) {
    case 0: {
      HardCases cases(random.next());
      for (std::uint64_t skip = random.below(predicates().size()); skip > 0; --skip) cases.next();
      const HardCase drawn = cases.next();
      in.operands = drawn.operands;
      in.which = static_cast<std::uint8_t>(
          std::find(predicates().begin(), predicates().end(), drawn.predicate) -
          predicates().begin());
      break;
    }
    case 1: any() = any(); break;
    case 2: any() = -any(); break;
    case 3: {
      double& v = any();
      v = std::nextafter(v, random.below(2) == 0 ? 0 : 2 * v);
      break;
    }
    case 4: {
      double& v = any();
      const double scaled = std::ldexp(v, static_cast<int>(random.between(-1100, 1100)));
      if (std::isfinite(scaled)) v = scaled;
      break;
    }
    default: {
      const int power = static_cast<int>(random.between(-300, 300));
      for (double& v : in.operands) {
        const double scaled = std::ldexp(v, power);
        if (std::isfinite(scaled)) v = scaled;
      }
    }
  }
  return in.encode(data, max_size);
}
