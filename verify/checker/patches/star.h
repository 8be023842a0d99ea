// SPDX-License-Identifier: Apache-2.0 OR MIT
// star.h: what the parts of star-box-1 and star-box-2 share. The pages: docs/certificates/star-box.md and
// star-box-2.md. A body of version 1 is one of version 2 without frames and separators, whose star boxes have one sheet
// each, with the stricter S1 of version 1.
#pragma once
#include <functional>
#include <memory>

#include "../common/checker.h"
#include "big.h"

const uint32_t kNoPair = 0xffffffff;
const int kLevels = 24;                        // below the roots
const int64_t kFarthest = int64_t(1) << 61;    // absolute values of coordinates are less
const int kMostShift = 120;                    // s of a box in a frame; a limit of this checker
const int64_t kWholeSide = int64_t(1) << 40;   // parameters count 2^-40 of a patch
const int kMostDegree = 15, kMostUnit = 4096;  // limits of a patch; of |E| and s
const int64_t kMostBits = 8192, kMostKnotBits = 2048, kMostSize = 1 << 20;  // section 3
const uint64_t kFreeUnits = 1 << 23, kUnitsOfByte = 96;                     // of work

// Numbers that several entities may share: a short file can name the same long ones many times.
class Numbers {
 public:
  Numbers() : Numbers(std::vector<Ratio>()) {}
  Numbers(std::vector<Ratio> v) : list_(std::make_shared<const std::vector<Ratio>>(std::move(v))) {}
  operator const std::vector<Ratio>&() const { return *list_; }
  const Ratio& operator[](size_t i) const { return (*list_)[i]; }
  size_t size() const { return list_->size(); }

 private:
  std::shared_ptr<const std::vector<Ratio>> list_;
};

// A surface or triangle of the model, or a volume, which is of another kind for the claims.
struct Entity {
  enum Kind { kOther, kSurface, kTriangle } kind = kOther;
  bool is_rational = false;
  int64_t components = 0;
  std::vector<int64_t> degrees;  // one for a triangle, two for a surface, three for a volume
  std::vector<Numbers> knots;    // an axis each; of a triangle: none
  uint64_t left_out = 0;         // numbers of each control point after the first three: attributes of volumes
  Numbers numbers;               // of control points, `components` and `left_out` each
  std::vector<uint64_t> places;  // of the control points in the list of numbers, last axis fastest

  bool is_volume() const { return kind == kOther && degrees.size() == 3; }
  uint64_t points_along(size_t axis) const {
    return knots[axis].size() - uint64_t(degrees[axis]) - 1;
  }
  const Ratio& number(uint64_t point, size_t component) const {
    const uint64_t first = places[point] * (uint64_t(components) + left_out);
    return numbers[size_t(first + component + (component < 3 ? 0 : left_out))];
  }
};
// format: one of those of docs/certificates/star-box.md
std::vector<Entity> read_spline_model(const std::string& file, const std::string& format);
// The volumes of a file, by section 1 of docs/certificates/reading-rule-faces.md. format: the file's, without "-faces"
std::vector<Entity> read_volumes(const std::string& file, const std::string& format);

// Control points or Bernstein coefficients: of a tensor product of degrees p, q, v fastest; or of a
// triangle of degree p (= q), first index falling, then the second.
struct Shape {
  bool is_triangle;
  int p, q;
  int count() const { return is_triangle ? (p + 1) * (p + 2) / 2 : (p + 1) * (q + 1); }
  int sides() const { return is_triangle ? 3 : 4; }
  int at(int i, int j) const { return i * (q + 1) + j; }                 // tensor
  int at3(int j, int k) const { return (j + k) * (j + k + 1) / 2 + k; }  // triangle; i = p - j - k
  // How many coefficients g of section 4 has.
  int count_of_g() const { return is_triangle ? 3 * p * (3 * p - 1) / 2 : 9 * p * q; }
  int side_degree(int e) const { return !is_triangle && e % 2 == 0 ? p : e % 2 != 0 ? q : p; }
  int on_side(int e, int k) const;  // the k-th point of side e's row, in its direction of travel
};
inline int Shape::on_side(int e, int k) const {
  if (is_triangle) return e == 0 ? at3(p - k, k) : e == 1 ? at3(0, p - k) : at3(k, 0);
  return e == 0 ? at(k, 0) : e == 1 ? at(p, k) : e == 2 ? at(p - k, q) : at(0, q - k);
}

struct Patch {
  Shape shape;
  bool is_rational, is_reversed;
  bool is_flat;  // as the version of the body has it
  uint8_t roots[2];
  uint64_t first_root;
  bool is_outer[4];      // for each side: on the border of the entity's domain, not inside of it
  std::vector<Big> net;  // shape.count() points (X, Y, Z, W), in units 2^E, no common factor
  int64_t bits;          // of the longest number of the net
  uint32_t pair[4];      // for each side; collapsed: kNoPair
  bool is_second[4];     // whether the side is the second of its pair
  uint32_t vertex[4], component;

  bool is_collapsed(int e) const { return pair[e] == kNoPair; }
  // 64 bits each, of four numbers for each control point: what dms-solid.md, D3, counts.
  uint64_t words() const { return uint64_t(shape.count()) * uint64_t((bits + 15) / 16); }
  uint64_t num_roots() const { return uint64_t(1) << (roots[0] + roots[1]); }
  int64_t bits_at(int level) const {  // h of the page's last paragraph
    return bits + (shape.p + shape.q) * (level + std::max(roots[0], roots[1]));
  }
  uint64_t cost_of_products() const {  // of g on the patch, once
    const uint64_t limbs = 2 + uint64_t(2 * bits) / 64;
    const Shape two = {shape.is_triangle, 2 * shape.p, 2 * shape.q};
    return 1 + uint64_t(shape.count() * two.count()) * limbs * limbs / 64;
  }
  // Units of work for a node: its hull; a side's curve that is halved; g on the node, if its hull does not miss the
  // box; S1 for the centres of a sheet.
  uint64_t cost_of_hull(int level) const {
    return 2 + uint64_t(shape.count() * (shape.p + shape.q) * bits_at(level)) / 4096;
  }
  uint64_t cost_of_half_curve(int level) const { return 16 * cost_of_hull(level); }
  uint64_t cost_of_g(int level) const {
    return 2 + uint64_t(shape.count_of_g() * (shape.p + shape.q) * bits_at(level)) / 2048;
  }
  uint64_t cost_of_s1(int level) const {
    return 1 + uint64_t(shape.count_of_g() * bits_at(level)) / 2048;
  }
};

struct Frame {  // the rows of A
  int64_t a[3][3];
};
struct Bounds {  // closed, in units 2^(E + shift); of boxes in frames shift is s, otherwise 0
  int64_t lo[3], hi[3];
  int shift = 0;
};
// q(x) = the sum of coefficient times y1^a y2^b y3^c with y = (x - o) / 2^scale, in the body's order; o is c- of the
// box's first sheet.
struct Separator {
  int degree;
  int64_t scale, length;  // length: the bits that o and the unit may add to coefficients
  std::vector<int64_t> coefficients;
};
struct Sheet {
  int64_t c[2][3];            // c-, c+, in units 2^E
  std::vector<int8_t> signs;  // of the separators: -1, 0 or 1
};
struct Box : Bounds {  // of A x, where A is the box's frame
  bool is_mesh;
  uint32_t frame;             // 0: the unit matrix
  uint32_t component;         // unused if there are several sheets
  int64_t place[3];           // a point near the box in the model's coordinates; decides nothing
  std::vector<Sheet> sheets;  // none in a mesh box
  std::vector<Separator> separators;
};
struct Walk {
  uint64_t box, end_box;
  int sign, end, end_sign;
  std::vector<int64_t> points;  // three coordinates each
  // The polyline from `first`, without the ray of an end at infinity.
  std::vector<int64_t> polyline(const int64_t* first, const std::vector<Box>& boxes) const {
    std::vector<int64_t> r(first, first + 3);
    r.insert(r.end(), points.begin(), points.end());
    const int64_t* const last = end < 6 ? first : boxes[end_box].sheets[0].c[end_sign];
    if (end == 6) r.insert(r.end(), last, last + 3);
    return r;
  }
};
struct StarBody {
  int version = 1;
  std::vector<Frame> frames = {Frame{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};  // the body's begin at 1
  std::vector<Patch> patches;
  std::vector<Box> boxes;
  std::vector<uint32_t> symbols;  // the trees', in the body's order: 0, or 1 + a box
  std::vector<Walk> walks;
  uint64_t num_reversed = 0, num_roots = 0;
  int64_t unit = 0;                        // E
  std::vector<std::vector<Ratio>> breaks;  // two for each surface
};

// Whether coefficients of this many bits are short enough for a patch of this shape: section 3.
inline bool are_short(const Shape& s, int64_t bits) { return s.count_of_g() * bits <= kMostSize; }

struct Place {  // a patch's entity, and the numbers of its intervals along u and v
  const Entity* entity;
  size_t surface, interval[2];  // surface: breaks 2 surface and 2 surface + 1 are its axes'
};
// B2 for the coefficients; use(patch) for each patch, in order.
void cut_patches(const std::vector<Place>& places, int64_t unit,
                 const std::vector<std::vector<Ratio>>& breaks,
                 const std::function<void(Patch&&)>& use);

struct Gluing {  // P1 and the numbers of X; fills the patches' fields of X
  // id: the condition that fails where P1 does not hold.
  explicit Gluing(std::vector<Patch>* patches, const char* id = "P1");
  uint64_t edges = 0, vertices = 0, genus = 0;
  uint32_t components = 0;
  std::vector<int64_t> chi;  // each component's
};

struct Units {  // the work of the page's last paragraph
  uint64_t done, limit;
  const char* id;

  static Units of_bytes(uint64_t bytes) {
    return Units{0, kFreeUnits + kUnitsOfByte * bytes, "C1"};
  }
  void add(uint64_t units) {
    done += units;
    require(done <= limit, id, "more work than allowed, units", limit);
  }
};
