// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/dms/read_dms.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "io/splines/spline_json_lexer.h"
#include "io/splines/spline_sniff.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

constexpr std::string_view kDmsFormatName = "veritope-dms-1";

class DmsReader : SplineJsonLexer {
 public:
  using SplineJsonLexer::SplineJsonLexer;
  using SplineTextReader::take_error;

  bool read();
  DmsFile take() {
    DmsFile file;
    file.model = std::move(model_);
    file.bytes = source_.size();
    file.beyond_default_limits = SplineTextReader::take().beyond_default_limits;
    return file;
  }

 private:
  // What is read of the model, or of its attribute domain.
  struct Part {
    DmsModel* model = nullptr;
    DmsEntries entries;
    std::vector<const char*> clouds_at, entries_at;
  };

  template <typename Value>
  bool read_in_order(std::initializer_list<std::string_view> keys, Value value,
                     std::size_t num_optional);
  bool read_member(std::size_t key);
  bool read_format();
  bool read_attribute_domain();
  bool read_degree();
  bool read_attributes();
  bool read_clouds();
  bool read_tetrahedra();
  bool read_control();
  bool read_entry();
  bool check_entry(const char* at, bool has_at, bool has_tetrahedron, bool has_beta);
  bool set_control(const char* at);

  bool read_coordinate(Rational& number) {
    skip();
    const char* const at = p_;
    return read_exact(number) && accept(at, check_dms_number(number));
  }
  // Reads a list of so many natural numbers up to `most` and appends them.
  bool read_naturals(const char* what, std::size_t count, std::uint64_t most,
                     std::vector<std::uint32_t>& into);
  // Whether the items of a list, `count` with the one at the cursor, are at most so many.
  bool is_within(std::size_t count, std::size_t most, const char* what) {
    return count <= most ||
           fail(p_, Code::kOverLimit, "more than " + std::to_string(most) + " " + what);
  }
  // Passes on what a part lacks, with the line of the part.
  // What a file has is never wrong usage.
  bool accept(const char* at, const Status& status) {
    if (status) return true;
    Error error = status.error();
    if (error.code == Code::kBadArgument) error.code = Code::kSyntax;
    return fail_with(at, std::move(error));
  }

  DmsModel model_;
  Part part_{&model_, {}, {}, {}};
};

bool DmsReader::read() {
  const bool ok = read_in_order(
      {"format", "degree", "attributes", "vertices", "tetrahedra", "control", "attribute_domain"},
      [&](std::size_t key) { return read_member(key); }, 1);
  return ok && (is_at_end() || fail_expected("the end of the file"));
}

template <typename Value>
bool DmsReader::read_in_order(std::initializer_list<std::string_view> keys, Value value,
                              std::size_t num_optional) {
  std::size_t next = 0;
  return read_object(
      keys,
      [&](std::size_t key) {
        if (key == next) {
          ++next;
          return value(key);
        }
        const std::size_t first = std::min(next, key), second = key < next ? next - 1 : key;
        return fail(p_, Code::kSyntax,
                    "the key " + quoted(keys.begin()[first]) + " must come before the key " +
                        quoted(keys.begin()[second]));
      },
      num_optional);
}

bool DmsReader::read_member(std::size_t key) {
  switch (key) {
    case 0: return read_format();
    case 1: return read_degree();
    case 2: return read_attributes();
    case 3: return read_clouds();
    case 4: return read_tetrahedra();
    case 5: return read_control();
    default: return read_attribute_domain();
  }
}

bool DmsReader::read_attribute_domain() {
  DmsModel& own = model_.attribute_domain.emplace_back();
  own.num_coordinates = 0;
  part_ = Part{&own, {}, {}, {}};
  return read_in_order(
      {"degree", "attributes", "vertices", "tetrahedra", "control"},
      [&](std::size_t key) { return read_member(key + 1); }, 0);
}

bool DmsReader::read_format() {
  skip();
  const char* const at = p_;
  std::string format;
  if (!read_string(format)) return false;
  return format == kDmsFormatName ||
         fail(at, Code::kUnknownFormat,
              "the format must be 'veritope-dms-1', not " + quoted(format));
}

bool DmsReader::read_degree() {
  skip();
  const char* const at = p_;
  std::uint64_t degree = 0;
  if (!read_natural("the degree", kMaxDmsDegree, degree, 1)) return false;
  part_.model->degree = static_cast<int>(degree);
  return accept(at, check_dms_degree(degree));
}

bool DmsReader::read_attributes() {
  skip();
  const char* const start = p_;
  DmsModel& dms = *part_.model;
  const bool is_own = &dms != &model_;
  const bool ok = read_list([&] {
    skip();
    const char* const at = p_;
    const std::size_t number = dms.attributes.size();
    return is_within(number + 1, kMaxDmsAttributes, "attributes") &&
           read_string(dms.attributes.emplace_back()) &&
           accept(at, check_dms_attribute(dms, number)) &&
           (!is_own || accept(at, check_own_attribute(model_, dms, number)));
  });
  return ok && (!is_own || accept(start, check_has_attributes(dms)));
}

bool DmsReader::read_clouds() {
  skip();
  const char* const start = p_;
  const bool ok = read_list([this] {
    skip();
    const char* const at = p_;
    if (!is_within(part_.model->clouds.size() + 1, kMaxDmsVertices, "vertices")) return false;
    part_.clouds_at.push_back(at);
    DmsCloud& cloud = part_.model->clouds.emplace_back();
    return read_list([&] {
             if (!is_within(cloud.size() + 1, static_cast<std::size_t>(part_.model->degree) + 1,
                            "knots of a vertex"))
               return false;
             DmsPoint& knot = cloud.emplace_back();
             return read_counted("a knot", 3,
                                 [&](std::size_t c) { return read_coordinate(knot[c]); });
           }) &&
           accept(at, check_dms_cloud(*part_.model, part_.model->clouds.size() - 1));
  });
  return ok && (part_.model->clouds.size() >= 4 ||
                fail(start, Code::kSyntax,
                     "there are " + std::to_string(part_.model->clouds.size()) +
                         " vertices, fewer than 4"));
}

bool DmsReader::read_tetrahedra() {
  skip();
  const char* const start = p_;
  std::vector<std::uint32_t> corners;
  const bool ok = read_list([&] {
    skip();
    const char* const at = p_;
    if (!is_within(part_.model->tetrahedra.size() + 1, kMaxDmsTetrahedra, "tetrahedra"))
      return false;
    corners.clear();
    if (!read_naturals("a tetrahedron", 4, kMaxDmsVertices - 1, corners)) return false;
    part_.model->tetrahedra.push_back({corners[0], corners[1], corners[2], corners[3]});
    return accept(at, check_dms_tetrahedron(*part_.model, part_.model->tetrahedra.size() - 1));
  });
  return ok &&
         (!part_.model->tetrahedra.empty() || fail(start, Code::kSyntax, "there are 0 tetrahedra"));
}

bool DmsReader::read_control() {
  skip();
  const char* const start = p_;
  return read_list([this] { return read_entry(); }) && set_control(start);
}

bool DmsReader::read_entry() {
  skip();
  const char* const at = p_;
  bool has_at = false, has_tetrahedron = false, has_beta = false;
  std::vector<std::uint32_t> vertices, tetrahedron, beta;
  part_.entries_at.push_back(at);
  const bool ok = read_object(
      {"value", "at", "tetrahedron", "beta"},
      [&](std::size_t key) {
        std::uint64_t number = 0;
        switch (key) {
          case 0:
            return read_counted("a value", part_.model->num_components(), [this](std::size_t) {
              return read_coordinate(part_.entries.values.emplace_back());
            });
          case 1:
            has_at = true;
            return read_naturals("the place of a control point",
                                 static_cast<std::size_t>(part_.model->degree), kMaxDmsVertices - 1,
                                 vertices);
          case 2:
            has_tetrahedron = true;
            if (!read_natural("the tetrahedron of a control point", kMaxDmsTetrahedra - 1, number))
              return false;
            tetrahedron.push_back(static_cast<std::uint32_t>(number));
            return true;
          default: has_beta = true; return read_naturals("beta", 4, kMaxDmsDegree, beta);
        }
      },
      3);
  if (!ok || !check_entry(at, has_at, has_tetrahedron, has_beta)) return false;
  for (const auto* const part : {&vertices, &tetrahedron, &beta})
    part_.entries.keys.insert(part_.entries.keys.end(), part->begin(), part->end());
  return accept(at, check_dms_key(*part_.model, part_.entries, part_.entries_at.size() - 1));
}

// Whether the keys are those of one kind, and the kind is that of the entries before.
bool DmsReader::check_entry(const char* at, bool has_at, bool has_tetrahedron, bool has_beta) {
  if (has_at && (has_tetrahedron || has_beta))
    return fail(at, Code::kSyntax,
                "a control point has the key 'at', or the keys 'tetrahedron' and 'beta', not both");
  if (!has_at && (!has_tetrahedron || !has_beta))
    return fail(at, Code::kSyntax,
                std::string("the key ") +
                    (has_beta          ? "'tetrahedron'"
                     : has_tetrahedron ? "'beta'"
                                       : "'at'") +
                    " is missing");
  if (part_.entries_at.size() == 1) part_.entries.are_separate = !has_at;
  return part_.entries.are_separate == !has_at ||
         fail(at, Code::kSyntax,
              "control points must all be shared or all be separate, as the first one is");
}

bool DmsReader::set_control(const char* at) {
  if (part_.entries.are_separate)
    if (const Status status = check_separate_clouds(*part_.model); !status)
      return accept(part_.clouds_at[status.error().place.entity.value_or(0)], status);
  const Status status = set_dms_control(*part_.model, std::move(part_.entries));
  if (status) return true;
  const auto entry = status.error().place.entity;
  return accept(entry ? part_.entries_at[*entry] : at, status);
}

bool DmsReader::read_naturals(const char* what, std::size_t count, std::uint64_t most,
                              std::vector<std::uint32_t>& into) {
  const std::string item = std::string("a number of ") + what;
  return read_counted(what, count, [&](std::size_t) {
    std::uint64_t n = 0;
    if (!read_natural(item.c_str(), most, n)) return false;
    into.push_back(static_cast<std::uint32_t>(n));
    return true;
  });
}

}  // namespace

bool looks_like_dms(const Source& source) { return starts_with_format(source, kDmsFormatName); }

Result<DmsFile> read_dms(DmsFormat format, const Source& source, const ReadLimits& limits) {
  DmsReader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  DmsFile file = reader.take();
  file.format = format;
  return file;
}

}  // namespace veritope
