// SPDX-License-Identifier: Apache-2.0 OR MIT
// expression_points.cc: the conditions of docs/certificates/points.md, section 7, in their order.
#include "expression_points.h"

#include "solid_points.h"

namespace {

const size_t kMostTable = 12;  // variables whose functions are tabulated
const int kDirections = 6, kOnSurface = 12, kOpen = 13, kNotCovered = 14;  // codes

enum Value3 { kZero, kOne, kMixed };
enum Place3 { kOut, kIn, kOnBoundary };
Place3 place_of(bool value) { return value ? kIn : kOut; }
Place3 place_of(const Answer& a) {
  return a.word == Answer::kOn ? kOnBoundary : place_of(a.f == 1);
}

struct Logic3 {  // the values 0, 1 and mixed
  typedef Value3 Value;
  std::function<Value3(uint32_t)> ask;

  Value variable(uint32_t v) const { return ask(v); }
  bool is_all(Value v, bool bit) const { return v == (bit ? kOne : kZero); }
  static Value complement(Value v) { return v == kMixed ? kMixed : v == kOne ? kZero : kOne; }
  static Value meet(Value a, Value b) {
    if (a == kZero || b == kZero) return kZero;
    return a == kOne && b == kOne ? kOne : kMixed;
  }
  Value joined(ExpressionNode::Kind kind, Value a, Value b) const {
    if (kind == ExpressionNode::kUnion) return complement(meet(complement(a), complement(b)));
    return meet(a, kind == ExpressionNode::kDifference ? complement(b) : b);
  }
};

// Functions of some bits as tables: word i / 64 has bit i % 64 for the bits of i.
struct Tables {
  typedef std::vector<uint64_t> Value;
  std::function<Value(uint32_t)> ask;

  static Value constant(size_t num_bits, bool value) {
    return Value(num_bits > 6 ? size_t(1) << (num_bits - 6) : 1, value ? ~uint64_t(0) : 0);
  }
  static Value of_bit(size_t num_bits, size_t k) {
    Value r = constant(num_bits, false);
    for (size_t i = 0; i < 64 * r.size(); ++i)
      if (i >> k & 1) r[i / 64] |= uint64_t(1) << i % 64;
    return r;
  }
  static bool bit(const Value& v, size_t i) { return (v[i / 64] >> i % 64 & 1) != 0; }

  Value variable(uint32_t v) const { return ask(v); }
  bool is_all(const Value& v, bool bit) const {
    return std::all_of(v.begin(), v.end(),
                       [bit](uint64_t w) { return w == (bit ? ~uint64_t(0) : 0); });
  }
  Value joined(ExpressionNode::Kind kind, Value a, const Value& b) const {
    for (size_t i = 0; i < a.size(); ++i)
      a[i] = kind == ExpressionNode::kUnion          ? a[i] | b[i]
             : kind == ExpressionNode::kIntersection ? a[i] & b[i]
                                                     : a[i] & ~b[i];
    return a;
  }
};

struct Asked {        // what is known of a variable at a point
  uint64_t line = 0;  // of the point
  Value3 value = kMixed;
  bool is_on = false;  // if the value is mixed: on the boundary, or open
  PlaceOnPatch place;
};

class ExpressionCheck {
 public:
  ExpressionCheck(const Statement& s, const std::string& file, const Body& body, size_t num_points)
      : e_(read_expression(file, s.model_name, s.read_file)),
        nearest_(s.text.at("decimals") == "nearest"),
        bytes_(body),
        asked_(e_.variables.size()),
        work_{Work(0), PointUnits(0, 0)} {
    const uint64_t body_size = body.left();
    require(bytes_.body.begins_with("VTPT"), "B1", "the body does not start with VTPT");
    require(bytes_.body.natural(4) == e_.solids.size(), "B1", "the number of solids is",
            e_.solids.size());
    require(bytes_.body.natural(4) == e_.leaves, "B1", "the number of operands is", e_.leaves);
    require(bytes_.body.natural(8) == num_points, "B1", "the number of points is", num_points);
    num_not_covered_ = bytes_.body.natural(8);
    uint64_t faces = 0, size = file.size() + body_size;
    for (Expression::Solid& solid : e_.solids) {
      size += solid.bytes.size();
      solids_.emplace_back(new SolidPoints(solid, s.flag.at("as_indexed"), body_size, &bytes_));
      faces += solids_.back()->num_faces();
      std::string().swap(solid.bytes);
    }
    for (const Expression::Containment& c : e_.containments) check_containment(c);
    const uint64_t questions = num_points + body_size;
    work_.triangles.limit = 10 * faces + 1000 * questions;
    work_.patches = PointUnits(size, questions);
    wedge_units_ = (uint64_t(1) << 23) + 4096 * num_points;
  }

  uint64_t check(const std::vector<Answer>& answers) {
    uint64_t found = 0;
    for (size_t i = 0; i < answers.size(); ++i) {
      line_ = i + 1;
      if (answers[i].word == Answer::kUndecided) continue;
      found += !is_covered(answers[i]);
      require(found <= num_not_covered_, "B1", "more points are not covered than",
              num_not_covered_);
    }
    require(found == num_not_covered_, "B1", "the number of points that are not covered is", found);
    bytes_.end();
    return found;
  }

 private:
  void check_containment(const Expression::Containment& c) const {
    const Bounds3& inner = c.is_solid ? solids_[c.solid]->box() : c.inner;
    for (int k = 0; k < 3; ++k)
      require(compare(c.box.lo[k], inner.lo[k]) < 0 && compare(inner.hi[k], c.box.hi[k]) < 0, "O2",
              ("not in the interior of the box: the operand " + c.operand).c_str());
  }

  // Whether the answer is proved. P5, and what the operands' codes fail.
  bool is_covered(const Answer& a) {
    const AnsweredPoint q(a, nearest_, " in line " + std::to_string(line_));
    met_.clear();
    is_marked_ = false;
    Logic3 logic = {[&](uint32_t v) { return ask(v, q); }};
    const Value3 value = evaluate(e_, &logic);
    if (is_marked_) return false;
    if ((value == kMixed ? place_on_walls(q) : place_of(value == kOne)) != place_of(a))
      throw Rejected{"P5", "another word follows" + q.where};
    return true;
  }

  Value3 ask(uint32_t v, const AnsweredPoint& q) {
    Asked& known = asked_[v];
    if (known.line == line_ || is_marked_) return known.line == line_ ? known.value : kMixed;
    known.line = line_;
    known.is_on = false;
    const Expression::Variable& variable = e_.variables[v];
    known.value = variable.is_box ? value_of_box(e_.boxes[variable.number], q, &known)
                                  : value_of_solid(*solids_[variable.number], q, &known);
    if (known.value == kMixed) met_.push_back(v);
    return known.value;
  }
  static Value3 value_of_box(const Bounds3& box, const AnsweredPoint& q, Asked* known) {
    for (int k = 0; k < 3; ++k) {
      const int lo = q.compare_with(k, box.lo[k]), hi = q.compare_with(k, box.hi[k]);
      if (lo < 0 || hi > 0) return kZero;
      known->is_on = known->is_on || lo == 0 || hi == 0;
    }
    return known->is_on ? kMixed : kOne;
  }
  Value3 value_of_solid(const SolidPoints& solid, const AnsweredPoint& q, Asked* known) {
    if (!solid.box_holds(q)) return kZero;
    const int code = int(bytes_.at_most(bytes_.body.natural(1), kNotCovered, "there is no code"));
    is_marked_ = code == kNotCovered;
    if (code >= kOpen) return kMixed;
    if (code == kOnSurface) {
      known->place = solid.read_on(q, &bytes_, &work_);
      known->is_on = true;
      return kMixed;
    }
    const int f = code / kDirections;
    solid.check_off(q, code % kDirections, f, &work_);
    return f == 1 ? kOne : kZero;
  }

  // By the variables that are mixed: G of the page is a function of their bits.
  Place3 place_on_walls(const AnsweredPoint& q) {
    std::vector<size_t> relevant;  // positions in met_
    Tables::Value table;
    for (size_t k = 0; k < met_.size(); ++k) relevant.push_back(k);
    if (met_.size() <= kMostTable) {
      table = table_of_g();
      const auto is_irrelevant = [&](size_t k) { return !depends(table, k); };
      relevant.erase(std::remove_if(relevant.begin(), relevant.end(), is_irrelevant),
                     relevant.end());
      if (relevant.empty()) return place_of(Tables::bit(table, 0));
    }
    for (size_t k : relevant)
      if (!asked_[met_[k]].is_on)
        throw Rejected{"P5", "the word depends on a solid that is open" + q.where};
    if (relevant.size() == 1) return kOnBoundary;
    const ValuesNearby found =
        values_nearby(cones_of(q, relevant), [&](const std::vector<bool>& bits) {
          size_t index = 0;
          for (size_t k = 0; k < relevant.size() && !table.empty(); ++k)
            index |= size_t(bits[k]) << relevant[k];
          return table.empty() ? value_of_g(bits) : Tables::bit(table, index);
        });
    if (found.fault != nullptr) throw Rejected{"P5", found.fault + q.where};
    return found.has[0] && found.has[1] ? kOnBoundary : place_of(found.has[1]);
  }
  bool is_one(uint32_t v) const { return asked_[v].line == line_ && asked_[v].value == kOne; }
  Tables::Value table_of_g() const {
    const size_t n = met_.size();
    Tables tables = {[&](uint32_t v) {
      const size_t k = size_t(std::find(met_.begin(), met_.end(), v) - met_.begin());
      return k < n ? Tables::of_bit(n, k) : Tables::constant(n, is_one(v));
    }};
    return evaluate(e_, &tables);
  }
  bool depends(const Tables::Value& table, size_t k) const {
    for (size_t i = 0; i < size_t(1) << met_.size(); ++i)
      if (Tables::bit(table, i) != Tables::bit(table, i ^ (size_t(1) << k))) return true;
    return false;
  }
  // By the bits of all of met_.
  bool value_of_g(const std::vector<bool>& bits) const {
    std::map<uint32_t, bool> bit_of;
    for (size_t k = 0; k < met_.size(); ++k) bit_of[met_[k]] = bits[k];
    Logic3 logic = {[&](uint32_t v) {
      const auto at = bit_of.find(v);
      return (at != bit_of.end() ? at->second : is_one(v)) ? kOne : kZero;
    }};
    return evaluate(e_, &logic) == kOne;
  }

  std::vector<Cone> cones_of(const AnsweredPoint& q, const std::vector<size_t>& relevant) {
    std::vector<Cone> cones;
    uint64_t n = 0;
    for (size_t k : relevant) {
      cones.emplace_back();
      if (!find_cone(met_[k], q, &cones.back()))
        throw Rejected{"P5", "a wall there is not flat" + q.where};
      n += cones.back().size();
    }
    const uint64_t evaluations = met_.size() > kMostTable ? 1 + e_.leaves / 64 : 1;
    const uint64_t units = n < 1000 ? (n * n + n * n * n / 32) * evaluations : kMostWedgeUnits + 1;
    require(units <= kMostWedgeUnits && units <= wedge_units_, "B1",
            "more work than allowed, wedges", n);
    wedge_units_ -= units;
    return cones;
  }
  bool find_cone(uint32_t v, const AnsweredPoint& q, Cone* cone) {
    const Expression::Variable& variable = e_.variables[v];
    if (!variable.is_box)
      return solids_[variable.number]->find_cone(q, asked_[v].place, &work_, cone);
    const Bounds3& box = e_.boxes[variable.number];
    int lo[3], hi[3];  // the signs of the sides minus the point
    for (int k = 0; k < 3; ++k) {
      lo[k] = -q.compare_with(k, box.lo[k]);
      hi[k] = -q.compare_with(k, box.hi[k]);
    }
    for (int k = 0; k < 3; ++k)
      for (bool upper : {false, true})
        if ((upper ? hi : lo)[k] == 0) add_side(lo, hi, k, upper, cone);
    return true;
  }
  // The side of a box across axis k; a cone depends on signs only.
  static void add_side(const int* lo, const int* hi, int k, bool upper, Cone* cone) {
    const int p = (k + 1) % 3, r = (k + 2) % 3;
    std::vector<BigVec> corners(4);
    for (int i = 0; i < 4; ++i) {  // counterclockwise around +k
      corners[size_t(i)].x[p] = i == 1 || i == 2 ? hi[p] : lo[p];
      corners[size_t(i)].x[r] = i >= 2 ? hi[r] : lo[r];
    }
    if (!upper) std::reverse(corners.begin(), corners.end());
    add_polygon(corners, cone);
  }

  static constexpr uint64_t kMostWedgeUnits = uint64_t(1) << 22;  // at a point

  Expression e_;
  const bool nearest_;
  Bytes bytes_;
  std::vector<Asked> asked_;
  SolidWork work_;
  uint64_t num_not_covered_ = 0, wedge_units_ = 0, line_ = 0;
  std::vector<std::unique_ptr<const SolidPoints>> solids_;
  std::vector<uint32_t>
      met_;  // variables that are mixed at the point, in the order in which they were asked for
  bool is_marked_ = false;  // the point is not covered
};

}  // namespace

uint64_t check_points_of_expression(const Statement& s, const std::string& file, const Body& body,
                                    const std::vector<Answer>& answers) {
  return ExpressionCheck(s, file, body, answers.size()).check(answers);
}
