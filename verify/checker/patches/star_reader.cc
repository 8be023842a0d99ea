// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_reader.cc: spline models, docs/formats/spline-json.md. Where no claim is made about a model that has entities of
// other kinds than those asked for, their shapes are read as JSON only.
#include "json_reader.h"
#include "star_model.h"

namespace {

const int kMostDepth = 100;  // nesting of such a shape, docs/certificates/star-box.md

struct VjsonReader : JsonReader {
  const bool has_volumes;
  uint64_t groups = 0;
  Numbers last;  // of the entity before, whose copies share them

  VjsonReader(const std::string& file, bool volumes, size_t* begin)
      : JsonReader(file, begin), has_volumes(volumes) {}
  void index() {  // null, or of a group read before
    if (next() == 'n') return expect(word() == "null", "expected null");
    const int64_t i = integer();
    expect(i >= 0 && uint64_t(i) < groups, "an index of a group is out of range");
  }
  void any(int depth) {
    expect(depth < kMostDepth, "nested too deep");
    const char c = next();
    if (c == '"') {
      string();
    } else if (c == '[') {
      list([&] { any(depth + 1); });
    } else if (c == '{') {
      std::map<std::string, bool> keys;
      take('{');
      if (take_if('}')) return;
      do {
        expect(keys.emplace(string(), true).second, "a key occurs twice");
        take(':');
        any(depth + 1);
      } while (take_if(','));
      take('}');
    } else {
      const std::string w = word();
      expect(w == "true" || w == "false" || w == "null" || is_integer(w), "expected a value");
    }
  }

  void group() {
    object({"name", "parent", "attributes"}, [&](size_t key) {
      if (key == 0) string();
      if (key == 1) index();
      if (key == 2) list([&] { string(); });
    });
    ++groups;
  }
  void points(std::vector<Ratio>* flat, uint64_t* count) {
    size_t each = 0;  // numbers of the first one
    list([&] {
      const size_t before = flat->size();
      list([&] { flat->push_back(read_number(string())); });
      if ((*count)++ == 0) each = flat->size();
      expect(flat->size() - before == each, "points have different numbers of components");
    });
  }
  Entity shape(Entity::Kind kind) {  // kOther: of a volume
    Entity e;
    e.kind = kind;
    std::vector<bool> periodic;
    std::vector<Ratio> flat;
    uint64_t count = 0;
    if (kind != Entity::kTriangle) {
      object({"points", "rational", "components", "degrees", "periodic", "knots"}, [&](size_t key) {
        if (key == 0) points(&flat, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) list([&] { e.degrees.push_back(integer()); });
        if (key == 4) list([&] { periodic.push_back(boolean()); });
        if (key == 5)
          list([&] {
            std::vector<Ratio> axis;
            list([&] { axis.push_back(read_number(string())); });
            e.knots.push_back(axis);
          });
      });
    } else {
      object({"points", "rational", "components", "degree"}, [&](size_t key) {
        if (key == 0) points(&flat, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) e.degrees.assign(1, integer());
      });
      periodic.push_back(false);
    }
    expect(e.components >= 0 && flat.size() == count * uint64_t(e.components),
           "a point has another number of components");
    const std::vector<Ratio>& known = last;
    if (flat != known) last = std::move(flat);
    e.numbers = last;
    e.places.reserve(count);
    for (uint64_t i = 0; i < count; ++i) e.places.push_back(i);
    check_entity(e, periodic);
    return e;
  }

  Entity entity() {
    Entity e;
    bool known = false;
    std::string kind;
    object({"kind", "group", "attributes", "shape"}, [&](size_t key) {
      if (key == 0) kind = string(), known = true;
      if (key == 1) index();
      if (key == 2) list([&] { string(); });
      if (key != 3) return;
      expect(known, "the shape stands before its kind");
      expect(!has_volumes || kind == "volume", "an entity is no volume");
      if (kind == "surface") e = shape(Entity::kSurface);
      if (kind == "triangle") e = shape(Entity::kTriangle);
      if (has_volumes) e = shape(Entity::kOther);
      if (kind == "surface" || kind == "triangle" || has_volumes) return;
      expect(kind == "curve" || kind == "volume" || kind == "trimmed" || kind == "model",
             "unknown kind");
      expect(next() == '{', "a shape is no object");
      any(0);
    });
    return e;
  }
  std::vector<Entity> model() {
    std::vector<Entity> entities;
    bool grouped = false;
    object({"format", "groups", "entities"}, [&](size_t key) {
      if (key == 0) expect(string() == "veritope-spline-1", "unknown format");
      if (key == 1) list([&] { group(); }), grouped = true;
      if (key != 2) return;
      expect(grouped, "the entities stand before the groups");
      list([&] { entities.push_back(entity()); });
    });
    return entities;
  }
};

}  // namespace

std::vector<Entity> read_json_part(const std::string& file, bool has_volumes, size_t* at) {
  return VjsonReader(file, has_volumes, at).model();
}
std::vector<Entity> read_json_model(const std::string& file, bool has_volumes, size_t* at) {
  VjsonReader reader(file, has_volumes, at);
  std::vector<Entity> entities = reader.model();
  expect(reader.next() == '\0' && *at == file.size(), "something follows the model");
  return entities;
}
