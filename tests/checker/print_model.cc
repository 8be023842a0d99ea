// SPDX-License-Identifier: Apache-2.0 OR MIT
// print_model.cc: print_model FORMAT FILE prints the entities that the C++ checker's readers find, all numbers as
// hexadecimal fractions; tests compare them with what the file means. A refusal is exit 4.
#include <fstream>
#include <iostream>
#include <iterator>

#include "verify/checker/patches/star.h"

namespace {

std::string hexadecimal(const Big& v) {
  std::string r = v.neg ? "-" : "";
  if (v.m.empty()) r += "0";
  for (size_t i = v.m.size(); i-- > 0;)
    for (int shift = 60; shift >= 0; shift -= 4) r += "0123456789abcdef"[v.m[i] >> shift & 15];
  return r;
}
std::string fraction(const Ratio& v) { return hexadecimal(v.n) + "/" + hexadecimal(v.d); }

void print(const Entity& e) {
  static const char* const kKinds[] = {"other", "surface", "triangle"};
  std::cout << "entity " << (e.is_volume() ? "volume" : kKinds[e.kind]) << ' ' << e.is_rational
            << ' ' << e.components << '\n';
  for (size_t a = 0; a < e.knots.size(); ++a) {
    std::cout << "axis " << e.degrees[a];
    for (size_t i = 0; i < e.knots[a].size(); ++i) std::cout << ' ' << fraction(e.knots[a][i]);
    std::cout << '\n';
  }
  for (uint64_t i = 0; i < e.places.size(); ++i) {
    std::cout << "point";
    for (size_t c = 0; c < size_t(e.components); ++c) std::cout << ' ' << fraction(e.number(i, c));
    std::cout << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream in(argv[2], std::ios::binary);
  const std::string file((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  try {
    for (const Entity& e : read_spline_model(file, argv[1])) print(e);
  } catch (const Refused& r) {
    std::cout << "refused " << r.why << '\n';
    return 4;
  }
  return 0;
}
