// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/certify_volumes_fuzz.cc: a few cells, changed as the bytes say, are written, read again and certified. The C++
// checker must accept the certificate, whatever the verdict; and cells that are described in another way must not have
// the opposite one.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "io/splines/write_splines.h"
#include "tests/certify/patch_round_trip.h"
#include "tests/support/checker_call.h"
#include "tests/support/v_cells.h"
#include "verify/certify/certify.h"

namespace veritope::fuzz {
namespace {

using v_cells::Point;

Verdict verdict_of(const std::vector<VVolume>& cells, std::uint8_t how) {
  SplineModel model;
  for (const VVolume& cell : cells) model.entities.push_back({cell, {}, {}, {}});
  const std::string file = spline_json_bytes(model);
  CertifyOptions options;
  options.max_cells = 60;
  options.tolerance = 0.1;
  options.wants_regular = (how & 1) != 0;
  if ((how & 2) != 0) options.orientation = PatchOrientation::kAuto;
  const Result<Certified> c = certify(ModelFile(spline_file_of(file)), options);
  if (!c || c->verdict == Verdict::kUndecided) return Verdict::kUndecided;
  const std::string& subject = c->copy ? c->copy->bytes : file;
  const std::string answer =
      check_in_process(subject, std::string(c->certificate.begin(), c->certificate.end()));
  if (answer.substr(0, 7) != "ACCEPT ") {
    std::fprintf(stderr, "%s\n%s\n", answer.c_str(), file.c_str());
    std::abort();
  }
  return c->verdict;
}

VVolume first_cell(std::uint8_t which) {
  switch (which % 5) {
    case 0: return v_cells::cube(0, 0, 0);
    case 1:  // a wedge
      return v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return Point{Rational(i == 1 && j == 0 ? 1 : 0), Rational(i == 1 && j == 1 ? 1 : 0),
                     Rational(static_cast<int>(k))};
      });
    case 2:  // a pyramid
      return v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        const int x = i == 0 ? -1 : 1, y = j == 0 ? -1 : 1, w = static_cast<int>(k);
        return Point{Rational(x * w), Rational(y * w), Rational(w)};
      });
    case 3:  // two pyramids with a common apex
      return v_cells::polynomial({1, 1, 2}, [](std::size_t i, std::size_t j, std::size_t k) {
        const int x = i == 0 ? -1 : 1, y = j == 0 ? -1 : 1, w = static_cast<int>(k) - 1;
        return Point{Rational(x * w), Rational(y * w), Rational(w)};
      });
    default: return elevate(v_cells::cube(0, 0, 0), 1, 1);
  }
}

class Cells {
 public:
  explicit Cells(std::uint8_t which) { cells_.push_back(first_cell(which)); }

  const std::vector<VVolume>& all() const { return cells_; }

  void change(const std::uint8_t* b) {
    const std::size_t number = b[1] % cells_.size();
    VVolume& cell = cells_[number];
    switch (b[0] % 8) {
      case 0:
        if (cells_.size() < 5)
          cells_.push_back(v_cells::cube(b[1] % 4 - 1, b[2] % 4 - 1, b[3] % 3 - 1));
        break;
      case 1:
      case 2: move(number, b, b[0] % 8 == 1); break;
      case 3:
        if (cell.axis(b[2] % 3).degree < 3) cell = elevate(cell, b[2] % 3, 1);
        break;
      case 4: insert(cell, b[2] % 3, b[3]); break;
      case 5: cell = v_cells::turned(cell, b[2] % 48); break;
      case 6:
        if (cells_.size() < 5) cells_.push_back(cell);
        break;
      default: cell = v_cells::with_factor(cell, Rational(1 + b[2] % 7)); break;
    }
  }

 private:
  // A control point, and those in equal places with it if `together`.
  void move(std::size_t number, const std::uint8_t* b, bool together) {
    const VVolume& cell = cells_[number];
    const std::size_t n = b[2] % cell.grid().count();
    const auto at = [](const VVolume& of, std::size_t i) {
      Point p;
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = of.component(static_cast<int>(c))[i];
        if (of.is_rational()) p[c] = p[c] / of.component(3)[i];
      }
      return p;
    };
    const Point from = at(cell, n);
    const std::size_t axis = b[0] / 8 % 3;
    const Rational by =
        Rational(static_cast<std::int8_t>(b[3])) / Rational(b[0] / 24 % 2 != 0 ? 32 : 4096);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (together || c == number)
        cells_[c] = v_cells::mapped(cells_[c], [&](Point p) {
          if (p == from) p[axis] = p[axis] + by;
          return p;
        });
  }
  static void insert(VVolume& cell, std::size_t axis, std::uint8_t where) {
    const auto& a = cell.axis(axis);
    const Rational t = Rational(1 + where % 5) / Rational(6);
    const Rational at = a.domain_begin() + (a.domain_end() - a.domain_begin()) * t;
    if (multiplicity(a, at) < a.degree && cell.grid().size[axis] < 6)
      cell = insert_knot(cell, axis, at);
  }

  std::vector<VVolume> cells_;
};

void check(const Cells& cells, std::uint8_t how) {
  const Verdict verdict = verdict_of(cells.all(), how);
  if (verdict == Verdict::kUndecided) return;
  Random random(how);
  std::vector<VVolume> others;
  for (const VVolume& cell : cells.all()) others.push_back(v_cells::redescribed(cell, random));
  const Verdict other = verdict_of(others, how);
  if (other == verdict || other == Verdict::kUndecided) return;
  for (const auto* const list : {&cells.all(), &std::as_const(others)})
    for (const VVolume& cell : *list) std::fputs(v_cells::text_of(cell).c_str(), stderr);
  std::abort();
}

}  // namespace
}  // namespace veritope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope::fuzz;
  if (size < 2 || size > 66) return 0;
  Cells cells(data[0]);
  for (std::size_t i = 2; i + 4 <= size; i += 4) cells.change(data + i);
  check(cells, data[1]);
  return 0;
}
