// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/dms_recurrence.h: two peers for FastDms: eq. 1 of [HHQ04] in plain binary64, without bounds and without
// decisions about points on planes. For one tetrahedron everything that does not depend on the point is computed
// before: which simplex splines may be other than zero in it, all sets of knots that their recurrences meet, and the
// planes of each. The recurrence looks a set up by its knots, and computes it when it is met first; the program has
// all sets in a list, parts before what they are parts of, and computes all.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_model.h"

namespace veritope::bench {

class DmsRecurrence {
 public:
  /// REQUIRES shared control points, a degree from 2 to 5.
  DmsRecurrence(const DmsModel& model, const DmsKnotTable& knots, std::uint32_t tetrahedron);

  std::size_t num_splines() const { return terms_.size(); }
  /// How many are not zero at the point of the last call of evaluate_program.
  std::size_t num_not_zero() const;
  /// REQUIRES a point inside of the tetrahedron, room for as many numbers as a control value has.
  void evaluate(const std::array<double, 3>& u, double* value);
  void evaluate_program(const std::array<double, 3>& u, double* value);

 private:
  using Plane = std::array<double, 4>;
  static constexpr std::size_t kMaxKnots = 8;
  /// Ascending numbers of knots, then the greatest number.
  struct Set {
    std::array<std::uint32_t, kMaxKnots> knots;
    std::size_t size = 0;
    Set() { knots.fill(0xffffffffu); }
    void insert(std::uint32_t knot);
    Set without(std::uint32_t knot) const;
    friend bool operator==(const Set&, const Set&) = default;
  };
  struct SetHash {
    std::size_t operator()(const Set& set) const;
  };
  struct Node {
    std::size_t size = 4;
    std::array<Plane, 4> lambda{};
    std::array<std::uint32_t, 4> knots{};
    std::array<std::uint32_t, 4> part{};  // 0 is the value 0
    double height = 0;
  };
  struct Place {
    std::uint32_t node = 0;  // 0 is the value 0
    double value = 0;
    std::uint64_t point = 0;  // for which the value is
  };
  struct Term {
    Set set;
    std::uint32_t node;
    std::array<Plane, 4> lambda;
    std::vector<double> value;  // d(W_γ) c, for each corner
  };
  std::array<double, 3> at(std::uint32_t knot) const;
  double frame(const std::array<std::uint32_t, 4>& knots, std::array<Plane, 4>& lambda) const;
  std::uint32_t node(const Set& set, const std::array<std::uint32_t, 4>* wanted);
  double value_of(const Set& set, const std::array<double, 3>& u);
  void add(const Term& t, double m, const std::array<double, 3>& u, double* value) const;

  const DmsKnotTable& knots_;
  std::size_t components_;
  std::unordered_map<Set, Place, SetHash> places_;
  std::uint64_t point_ = 0;
  std::vector<Node> nodes_;
  std::vector<double> values_;
  std::vector<Term> terms_;
};

}  // namespace veritope::bench
