// SPDX-License-Identifier: Apache-2.0 OR MIT
// mfem_reader.cc: NURBS meshes of MFEM, docs/certificates/reading-rule-mfem.md, section by section; mfem_topology.cc
// has what vertices and edges mean.
#include "mfem_topology.h"
#include "token_reader.h"

namespace {

const int64_t kSquare = 3, kCube = 5;  // geometries of patches

Ratio product(const Ratio& x, const Ratio& weight) {
  if (weight.n == Big(1) && weight.d == Big(1)) return x;
  return shortened(x.n * weight.n, x.d * weight.d);
}

// Sets `reversed` and `is_symmetric`, by integers over a common denominator.
void reverse(MfemKnots* k) {
  const std::vector<Ratio>& t = k->knots;
  Big common = 1;
  for (const Ratio& x : t) common = common * divide(x.d, gcd(common, x.d), nullptr);
  std::vector<Big> v;
  for (const Ratio& x : t) v.push_back(x.n * divide(common, x.d, nullptr));
  const Big ends = v.front() + v.back();
  std::vector<Ratio> r;
  k->is_symmetric = true;
  for (size_t i = 0; i < v.size(); ++i) {
    const Big to = ends - v[v.size() - 1 - i];
    k->is_symmetric = k->is_symmetric && to == v[i];
    r.push_back(shortened(to, common));
  }
  k->reversed = std::move(r);
}

struct MfemReader {
  TokenReader in;
  MfemTopology t;

  // Section 2.
  MfemKnots knot_vector() {
    MfemKnots r = MfemKnots();
    r.degree = in.integer(1, kMostSplineDegree);
    r.points = uint64_t(in.integer(r.degree + 1, int64_t(in.bytes())));
    r.knots = in.decimals(r.points + uint64_t(r.degree) + 1);
    check_knots(r.knots, r.degree, false);
    return r;
  }
  void sections() {
    in.take("dimension");
    t.axes = size_t(in.integer(2, 3));
    in.take("elements");
    for (int64_t left = in.integer(1, int64_t(in.bytes())); left > 0; --left) {
      in.integers(1);
      const int64_t geometry = t.axes == 2 ? kSquare : kCube;
      in.integer(geometry, geometry);
      for (int i = 0; i < 1 << t.axes; ++i) t.corners.push_back(in.count());
    }
    in.take("boundary");
    for (uint64_t left = in.count(); left > 0; --left) {
      in.integers(1);
      const int64_t geometry = in.value(0, kCube);
      expect(geometry <= 1 || geometry % 2 == 1, "expected a geometry: 0, 1, 3 or 5");
      in.next();
      for (int i = 0; i < (geometry < 2 ? 1 << geometry : 1 << (geometry + 1) / 2); ++i) in.count();
    }
    in.take("edges");
    for (uint64_t left = in.count(); left > 0; --left) {
      MfemEdge e = {in.count(), 0, 0};
      e.from = in.count();
      e.to = in.count();
      t.edges.push_back(e);
    }
    in.take("vertices");
    t.vertices = in.count();
    for (uint64_t v : t.corners) expect(v < t.vertices, "a patch has a vertex that does not exist");
  }

  Entity entity() const {  // without anything that differs by patch
    Entity e;
    e.kind = t.axes == 2 ? Entity::kSurface : Entity::kOther;
    e.is_rational = true;
    return e;
  }

  // Section 3.
  Entity patch() {
    Entity e = entity();
    std::vector<uint64_t> size;
    uint64_t points = 1;
    in.take("knotvectors");
    in.integer(int64_t(t.axes), int64_t(t.axes));
    for (size_t a = 0; a < t.axes; ++a) {
      const MfemKnots k = knot_vector();
      e.degrees.push_back(k.degree);
      e.knots.push_back(k.knots);
      size.push_back(k.points);
      points = in.product(points, k.points);
    }
    in.take("dimension");
    e.components = in.integer(1, kMostCoordinates) + 1;
    const bool is_cartesian = in.take_if("controlpoints_cartesian");
    if (!is_cartesian && !in.take_if("controlpoints_homogeneous")) in.take("controlpoints");
    const size_t c = size_t(e.components);
    std::vector<Ratio> flat = in.decimals(in.product(points, c));
    for (size_t i = 0; is_cartesian && i < flat.size(); ++i)
      if (i % c != c - 1) flat[i] = product(flat[i], flat[i - i % c + c - 1]);
    e.numbers = std::move(flat);
    e.places = first_axis_fastest(size, size);
    check_entity(e, std::vector<bool>(t.axes));
    return e;
  }

  // Section 4.
  void skip_refinements(size_t num_knots) {  // of version 1.1
    if (in.take_if("refinements")) in.integers(t.axes);
    if (in.take_if("knotvector_refinements"))
      for (size_t k = 0; k < num_knots; ++k) in.integers(in.count());
    in.take("spacing");
    for (uint64_t left = in.count(); left > 0; --left) {
      in.integers(2);
      const uint64_t integers = in.count(), decimals = in.count();
      in.integers(integers);
      in.decimals(decimals);
    }
  }
  void collection(const std::vector<MfemKnots>& knots) {
    in.take("FiniteElementSpace");
    in.take("FiniteElementCollection:");
    std::string degrees = "NURBS";
    if (in.token() != degrees) {
      degrees += std::to_string(knots[0].degree);
      for (const MfemKnots& k : knots)
        expect(k.degree == knots[0].degree && in.token() == degrees,
               "expected NURBS, or NURBS and the degree of all knot vectors");
    }
    in.next();
  }
  std::vector<Entity> connected_patches(bool is_newer) {
    std::vector<MfemKnots> knots;
    for (int64_t left = in.integer(1, int64_t(in.bytes())); left > 0; --left) {
      knots.push_back(knot_vector());
      reverse(&knots.back());
    }
    if (is_newer) skip_refinements(knots.size());
    const MfemNumbering mesh = number_points(t, knots, in.bytes());
    std::vector<Ratio> weights;
    if (in.take_if("weights"))
      weights = in.decimals(mesh.points);
    else if (!in.take_if("unitweights") && !in.take_if("autoweights"))
      throw Refused{"expected weights, unitweights or autoweights"};
    collection(knots);
    in.take("VDim:");
    const uint64_t d = uint64_t(in.integer(1, kMostCoordinates));
    in.take("Ordering:");
    const bool by_points = in.integer(0, 1) == 1;
    const std::vector<Ratio> x = in.decimals(in.product(mesh.points, d));

    weights.resize(mesh.points, Ratio(Big(1)));
    std::vector<Ratio> flat;  // where d is not 3, no claim needs it
    for (uint64_t m = 0; d == 3 && m < mesh.points; ++m) {
      for (uint64_t c = 0; c < d; ++c)
        flat.push_back(product(x[by_points ? m * d + c : c * mesh.points + m], weights[m]));
      flat.push_back(weights[m]);
    }
    const Numbers numbers = std::move(flat);
    std::vector<Entity> r;
    for (const MfemPatch& p : mesh.patches) {
      Entity e = entity();
      e.components = int64_t(d) + 1;
      for (size_t a = 0; a < t.axes; ++a) {
        const MfemKnots& k = knots[p.knots[a]];
        e.degrees.push_back(k.degree);
        e.knots.push_back(p.is_reversed[a] ? k.reversed : k.knots);
      }
      for (uint64_t m : p.points) expect(weights[m].n.sign() > 0, "a weight is not positive");
      if (d == 3) e.places = p.points;
      e.numbers = numbers;
      r.push_back(std::move(e));
    }
    return r;
  }

  std::vector<Entity> model() {
    for (const char* word : {"MFEM", "NURBS", "mesh"}) in.take(word);
    const bool is_newer = in.take_if("v1.1");
    if (!is_newer) in.take("v1.0");
    sections();
    std::vector<Entity> r;
    if (in.take_if("patches")) {
      for (size_t i = 0; i < t.patches(); ++i) r.push_back(patch());
    } else {
      in.take("knotvectors");
      r = connected_patches(is_newer);
    }
    expect(in.is_at_end(), "something follows the mesh");
    return r;
  }
};

}  // namespace

std::vector<Entity> read_mfem_model(const std::string& file, size_t* at) {
  MfemReader r = {TokenReader(file, true, at), MfemTopology()};
  return r.model();
}
