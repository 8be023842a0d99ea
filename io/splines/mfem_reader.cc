// SPDX-License-Identifier: LGPL-3.0-or-later
// MFEM's NURBS meshes, v1.0 and v1.1: patches with control points of their own ("patches"), or with knot vectors and
// control points shared through the topology ("knotvectors", then weights and a finite element space).
#include <algorithm>

#include "io/splines/mfem_topology.h"
#include "io/splines/spline_text_reader.h"

namespace veritope {
namespace {

struct KnotVector {
  int degree = 0;
  std::uint64_t num_control = 0;
  std::vector<Rational> knots;
};

class MfemReader : SplineTextReader {
 public:
  MfemReader(const Source& source, const ReadLimits& limits) : SplineTextReader(source, limits) {
    has_comments_ = true;
    ends_ = kTokenEndOrComment;
  }
  using SplineTextReader::take;
  using SplineTextReader::take_error;

  bool read();

 private:
  bool take_keyword(std::string_view word);
  bool read_header();
  bool read_topology();
  bool read_shape(std::uint64_t vertices_of_elements, std::vector<std::uint64_t>& vertices);
  bool read_knot_vector(KnotVector& knots);
  bool read_spacing();
  bool read_patches();
  template <std::size_t N>
  bool read_patch(const char* open);
  bool read_shared();
  bool read_nodes(const char* at, const MfemNumbering& numbering);
  bool read_space(std::uint64_t& dimension, bool& by_nodes);
  template <std::size_t N>
  bool gather(const MfemNumbering& numbering, std::uint64_t dimension, bool by_nodes);
  template <std::size_t N>
  bool add(const char* at, RawSpline<N> raw);

  bool is_v11_ = false;
  MfemTopology topology_;
  std::vector<std::string> attributes_;   // the patches'
  std::vector<const char*> patch_lines_;  // where each patch is named
  const char* edges_at_ = nullptr;
  std::vector<KnotVector> knot_vectors_;
  std::vector<Rational> weights_, nodes_;
};

bool MfemReader::take_keyword(std::string_view word) {
  if (peek() != word) return fail_expected("'" + std::string(word) + "'");
  p_ += word.size();
  return true;
}

bool MfemReader::read_header() {
  for (const char* word : {"MFEM", "NURBS", "mesh"})
    if (!take_keyword(word)) return false;
  is_v11_ = peek() == "v1.1";
  if (!is_v11_ && peek() != "v1.0") return fail_expected("the version v1.0 or v1.1");
  p_ += 4;
  return true;
}

// Reads "attribute geometry vertices"; for elements the dimension determines the geometry.
bool MfemReader::read_shape(std::uint64_t vertices_of_elements,
                            std::vector<std::uint64_t>& vertices) {
  skip();
  const char* const at = p_;
  std::int64_t attribute = 0, geometry = 0;
  if (!read_integer("an attribute", attribute) || !read_integer("a geometry", geometry))
    return false;
  const std::uint64_t count = geometry == 0   ? 1
                              : geometry == 1 ? 2
                              : geometry == 3 ? 4
                              : geometry == 5 ? 8
                                              : 0;
  if (count == 0 || (vertices_of_elements != 0 && count != vertices_of_elements))
    return fail(at, Code::kSyntax,
                "a patch of geometry " + std::to_string(geometry) + " in a mesh of dimension " +
                    std::to_string(topology_.dimension));
  vertices.resize(count);
  for (std::uint64_t& v : vertices)
    if (!read_count("a vertex", 0, source_.size(), v)) return false;
  if (vertices_of_elements == 0) return true;
  attributes_.push_back("attribute " + std::to_string(attribute));
  patch_lines_.push_back(at);
  return true;
}

bool MfemReader::read_topology() {
  std::uint64_t dimension = 0, count = 0;
  if (!take_keyword("dimension") || !read_count("the dimension", 1, 3, dimension)) return false;
  topology_.dimension = static_cast<int>(dimension);
  const std::uint64_t corners = std::uint64_t{1} << dimension;
  if (!take_keyword("elements") || !read_count("a number of patches", 0, bytes_left(), count))
    return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    std::vector<std::uint64_t> vertices;
    if (!read_shape(corners, vertices)) return false;
    topology_.patches.push_back(std::move(vertices));
  }
  if (!take_keyword("boundary") ||
      !read_count("a number of boundary parts", 0, bytes_left(), count))
    return false;
  if (count != 0) leave_out("boundary parts", "", false, count);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::vector<std::uint64_t> ignored;
    if (!read_shape(0, ignored)) return false;
  }
  skip();
  edges_at_ = p_;
  if (!take_keyword("edges") || !read_count("a number of edges", 0, bytes_left(), count))
    return false;
  for (std::uint64_t i = 0; i < count; ++i) {
    MfemTopology::Edge edge;
    if (!read_count("a knot vector's number", 0, source_.size(), edge.knot_vector) ||
        !read_count("a vertex", 0, source_.size(), edge.from) ||
        !read_count("a vertex", 0, source_.size(), edge.to))
      return false;
    topology_.edges.push_back(edge);
  }
  if (!take_keyword("vertices") ||
      !read_count("a number of vertices", 0, source_.size(), topology_.num_vertices))
    return false;
  for (std::size_t p = 0; p < topology_.patches.size(); ++p)
    for (const std::uint64_t v : topology_.patches[p])
      if (v >= topology_.num_vertices)
        return fail(
            patch_lines_[p], Code::kIndexOutOfRange,
            "vertex " + std::to_string(v) + " of " + std::to_string(topology_.num_vertices));
  return true;
}

bool MfemReader::read_knot_vector(KnotVector& knots) {
  skip();
  const char* const at = p_;
  std::uint64_t degree = 0;
  if (!read_count("a degree", 1, kMaxSplineDegree, degree) ||
      !read_count("a number of control points", 1, source_.size(), knots.num_control))
    return false;
  if (knots.num_control <= degree)
    return fail(at, Code::kBadSpline,
                "the order " + std::to_string(degree + 1) +
                    " is larger than the number of control points, " +
                    std::to_string(knots.num_control));
  knots.degree = static_cast<int>(degree);
  const std::uint64_t count = knots.num_control + degree + 1;
  if (!check_announced(count, "knots")) return false;
  knots.knots.resize(count);
  if (!read_all(knots.knots)) return false;
  auto axis = make_knot_axis(knots.degree, knots.knots);
  if (axis) return true;
  Error error = axis.error();
  if (error.code == Code::kBadArgument) error.code = Code::kBadSpline;
  return fail_with(at, error);
}

// Spacings say how the knots grade a refinement; they are not part of the map.
bool MfemReader::read_spacing() {
  std::uint64_t count = 0, integers = 0, reals = 0;
  std::int64_t ignored = 0;
  Rational unused;
  if (peek() == "refinements") {
    p_ += peek().size();
    for (int i = 0; i < topology_.dimension; ++i)
      if (!read_integer("a refinement factor", ignored)) return false;
  }
  if (peek() == "knotvector_refinements") {
    p_ += peek().size();
    for (std::size_t i = 0; i < knot_vectors_.size(); ++i) {
      if (!read_count("a number of factors", 0, bytes_left(), count)) return false;
      for (; count > 0; --count)
        if (!read_integer("a refinement factor", ignored)) return false;
    }
  }
  if (!take_keyword("spacing") || !read_count("a number of spacings", 0, bytes_left(), count))
    return false;
  if (count != 0) leave_out("spacings", "", false, count);
  for (; count > 0; --count) {
    if (!read_integer("a knot vector's number", ignored) ||
        !read_integer("a kind of spacing", ignored) ||
        !read_count("a number of integers", 0, bytes_left(), integers) ||
        !read_count("a number of reals", 0, bytes_left(), reals))
      return false;
    for (; integers > 0; --integers)
      if (!read_integer("a parameter", ignored)) return false;
    for (; reals > 0; --reals)
      if (!read_number(unused)) return false;
  }
  return true;
}

template <std::size_t N>
bool MfemReader::add(const char* at, RawSpline<N> raw) {
  auto spline = build(at, std::move(raw));
  if (!spline) return false;
  SplineEntity entity{std::move(*spline), {attributes_[model_.entities.size()]}, {}, place_of(at)};
  model_.entities.push_back(std::move(entity));
  return true;
}

template <std::size_t N>
bool MfemReader::read_patch(const char* open) {
  RawSpline<N> raw;
  for (std::size_t a = 0; a < N; ++a) {
    KnotVector knots;
    if (!read_knot_vector(knots)) return false;
    raw.degrees[a] = knots.degree;
    raw.num_control[a] = knots.num_control;
    raw.knots[a] = std::move(knots.knots);
  }
  std::uint64_t dimension = 0, total = 0;
  if (!take_keyword("dimension") || !read_count("a dimension", 1, 1000, dimension)) return false;
  const bool is_cartesian = peek() == "controlpoints_cartesian";
  if (!is_cartesian && peek() != "controlpoints" && peek() != "controlpoints_homogeneous")
    return fail_expected(
        "'controlpoints', 'controlpoints_homogeneous' or 'controlpoints_cartesian'");
  p_ += peek().size();
  raw.is_rational = true;
  raw.num_components = static_cast<int>(dimension) + 1;
  if (!check_grid(raw.num_control, dimension + 1, total)) return false;
  raw.points.resize(total);
  if (!read_all(raw.points)) return false;
  if (is_cartesian)
    for (std::uint64_t i = 0; i < total; i += dimension + 1)
      for (std::uint64_t c = 0; c < dimension; ++c)
        if (!multiply(open, raw.points[i + c], raw.points[i + dimension])) return false;
  return add(open, std::move(raw));
}

bool MfemReader::read_patches() {
  for (std::size_t p = 0; p < topology_.patches.size(); ++p) {
    entity_ = p;
    skip();
    const char* const open = p_;
    std::uint64_t dimension = 0;
    const auto expected = static_cast<std::uint64_t>(topology_.dimension);
    if (!take_keyword("knotvectors") ||
        !read_count("a number of knot vectors", expected, expected, dimension))
      return false;
    const bool ok = dimension == 1   ? read_patch<1>(open)
                    : dimension == 2 ? read_patch<2>(open)
                                     : read_patch<3>(open);
    if (!ok) return false;
  }
  entity_.reset();
  if (!is_at_end()) return fail_expected("the end of the file");
  return true;
}

bool MfemReader::read_space(std::uint64_t& dimension, bool& by_nodes) {
  if (!take_keyword("FiniteElementSpace") || !take_keyword("FiniteElementCollection:"))
    return false;
  const std::string collection(peek());
  bool is_known = collection.starts_with("NURBS");
  if (is_known && collection.size() > 5)
    for (const KnotVector& k : knot_vectors_)
      is_known = is_known && collection.substr(5) == std::to_string(k.degree);
  if (!is_known) return fail_expected("a collection NURBS or NURBSp for the degree p of the knots");
  p_ += collection.size();
  std::uint64_t ordering = 0;
  if (!take_keyword("VDim:") || !read_count("a dimension", 1, 1000, dimension) ||
      !take_keyword("Ordering:") || !read_count("an ordering", 0, 1, ordering))
    return false;
  by_nodes = ordering == 0;
  return true;
}

std::vector<Rational> reversed(const std::vector<Rational>& knots) {
  std::vector<Rational> out;
  const Rational sum = knots.front() + knots.back();
  for (auto k = knots.rbegin(); k != knots.rend(); ++k) out.push_back(sum - *k);
  return out;
}

template <std::size_t N>
bool MfemReader::gather(const MfemNumbering& numbering, std::uint64_t dimension, bool by_nodes) {
  const std::uint64_t num_points = numbering.num_points();
  for (std::size_t p = 0; p < topology_.patches.size(); ++p) {
    entity_ = p;
    RawSpline<N> raw;
    std::uint64_t total = 1;
    for (std::size_t a = 0; a < N; ++a) {
      const auto axis = static_cast<int>(a);
      const KnotVector& k = knot_vectors_[numbering.knot_vector(p, axis)];
      const auto turn = numbering.is_reversed(p, axis);
      auto turned = reversed(k.knots);
      if (!turn && turned != k.knots)
        return fail(patch_lines_[p], Code::kSyntax,
                    "the patch's edges disagree about the direction of a knot vector");
      raw.degrees[a] = k.degree;
      raw.num_control[a] = k.num_control;
      raw.knots[a] = turn.value_or(false) ? std::move(turned) : k.knots;
      for (const Rational& x : raw.knots[a])
        if (!charge(patch_lines_[p], x)) return false;
      total *= k.num_control;
    }
    raw.is_rational = true;
    raw.num_components = static_cast<int>(dimension) + 1;
    raw.points.reserve(total * (dimension + 1));
    for (std::uint64_t i = 0; i < total; ++i) {
      std::array<std::uint64_t, 3> index{};
      std::uint64_t rest = i;
      for (std::size_t a = 0; a < N; rest /= raw.num_control[a], ++a)
        index[a] = rest % raw.num_control[a];
      const std::uint64_t n = numbering.point(p, index);
      for (std::uint64_t c = 0; c < dimension; ++c) {
        raw.points.push_back(nodes_[by_nodes ? c * num_points + n : n * dimension + c] *
                             weights_[n]);
        if (!charge(patch_lines_[p], raw.points.back())) return false;
      }
      raw.points.push_back(weights_[n]);
      if (!charge(patch_lines_[p], raw.points.back())) return false;
    }
    if (!add(patch_lines_[p], std::move(raw))) return false;
  }
  entity_.reset();
  return true;
}

bool MfemReader::read_nodes(const char* at, const MfemNumbering& numbering) {
  const std::uint64_t num_points = numbering.num_points();
  if (num_points > source_.size() || numbering.num_patch_points() > source_.size())
    return fail(at, Code::kTruncated, "more control points than the file can hold");
  const std::string keyword(peek());
  if (keyword == "weights") {
    p_ += keyword.size();
    if (!check_announced(num_points, "weights")) return false;
    weights_.resize(num_points);
    if (!read_all(weights_)) return false;
  } else if (keyword == "unitweights" || keyword == "autoweights") {
    p_ += keyword.size();
    weights_.assign(num_points, Rational(1));
  } else if (keyword == "periodic" || keyword == "mesh_elements") {
    return fail(p_, Code::kSyntax, "the section '" + keyword + "' is not read");
  } else {
    return fail_expected("'weights' or 'unitweights'");
  }
  std::uint64_t dimension = 0;
  bool by_nodes = false;
  if (!read_space(dimension, by_nodes)) return false;
  if (!check_announced(num_points * dimension, "coordinates")) return false;
  nodes_.resize(num_points * dimension);
  if (!read_all(nodes_)) return false;
  if (!is_at_end()) return fail_expected("the end of the file");
  if (topology_.dimension == 1) return gather<1>(numbering, dimension, by_nodes);
  return topology_.dimension == 2 ? gather<2>(numbering, dimension, by_nodes)
                                  : gather<3>(numbering, dimension, by_nodes);
}

bool MfemReader::read_shared() {
  std::uint64_t count = 0;
  if (!read_count("a number of knot vectors", 1, bytes_left(), count)) return false;
  while (knot_vectors_.size() < count)
    if (!read_knot_vector(knot_vectors_.emplace_back())) return false;
  if (is_v11_ && !read_spacing()) return false;
  if (topology_.edges.empty() && !topology_.patches.empty())
    return fail(edges_at_, Code::kSyntax,
                "a mesh without edges does not say which knot vector a patch has");
  for (const MfemTopology::Edge& e : topology_.edges) {
    const bool is_wrong_vertex = e.from >= topology_.num_vertices || e.to >= topology_.num_vertices;
    if (e.knot_vector >= count || is_wrong_vertex)
      return fail(edges_at_, Code::kIndexOutOfRange,
                  "the edge " + std::to_string(e.knot_vector) + " " + std::to_string(e.from) + " " +
                      std::to_string(e.to) + " names a knot vector or a vertex that is not there");
  }
  std::vector<std::uint64_t> num_control;
  for (const KnotVector& k : knot_vectors_) num_control.push_back(k.num_control);
  const MfemNumbering numbering(topology_, num_control);
  if (numbering.fault()) return fail(edges_at_, Code::kSyntax, *numbering.fault());
  return read_nodes(edges_at_, numbering);
}

bool MfemReader::read() {
  if (!read_header() || !read_topology()) return false;
  if (peek() == "patches") {
    p_ += peek().size();
    return read_patches();
  }
  if (peek() != "knotvectors") return fail_expected("'knotvectors' or 'patches'");
  p_ += peek().size();
  return read_shared();
}

}  // namespace

Result<SplineFile> read_mfem(const Source& source, const ReadLimits& limits) {
  return run_reader<MfemReader>(source, limits);
}

}  // namespace veritope
