// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/dms/write_dms.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "io/base/json_string.h"

namespace veritope {
namespace {

class DmsWriter {
 public:
  explicit DmsWriter(const DmsModel& model) : model_(model) {}

  std::string write() {
    part("{\"format\": \"veritope-dms-1\",\n");
    for (const DmsModel& own : model_.attribute_domain) {
      DmsWriter writer(own);
      writer.part(",\n\"attribute_domain\": {");
      out_ += writer.out_ + '}';
    }
    return std::move(out_ += "}\n");
  }

 private:
  void part(std::string_view begin) {
    out_ += begin;
    out_ += "\"degree\": ";
    integer(static_cast<std::uint64_t>(model_.degree));
    out_ += ",\n\"attributes\": ";
    list(model_.attributes, ", ",
         [this](const std::string& name) { append_json_string(name, out_); });
    out_ += ",\n\"vertices\": ";
    lines(model_.clouds, [this](const DmsCloud& cloud) {
      list(cloud, ", ", [this](const DmsPoint& knot) { numbers(knot); });
    });
    out_ += ",\n\"tetrahedra\": ";
    lines(model_.tetrahedra, [this](const TetrahedronCorners& t) { integers(t); });
    out_ += ",\n\"control\": ";
    model_.control.is_separate ? separate() : shared();
  }
  template <typename List, typename Item>
  void list(const List& items, std::string_view separator, Item item,
            std::string_view begin = "[") {
    out_ += begin;
    bool is_first = true;
    for (const auto& i : items) {
      if (!is_first) out_ += separator;
      is_first = false;
      item(i);
    }
    out_ += ']';
  }
  // One element a line.
  template <typename List, typename Item>
  void lines(const List& items, Item item) {
    list(items, ",\n", item, "[\n");
  }
  template <typename List>
  void numbers(const List& items) {
    list(items, ", ", [this](const Rational& r) { out_ += '"' + r.to_string() + '"'; });
  }
  void integer(std::uint64_t n) {
    char digits[24];
    out_.append(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
  }
  template <typename List>
  void integers(const List& items) {
    list(items, ",", [this](auto n) { integer(static_cast<std::uint64_t>(n)); });
  }
  void value(std::size_t control_point) {
    out_ += ", \"value\": ";
    numbers(model_.value(control_point));
    out_ += '}';
  }
  void shared() {
    const auto n = static_cast<std::size_t>(model_.degree);
    out_ += "[\n";
    for (std::size_t c = 0; c < model_.num_control(); ++c) {
      out_ += c > 0 ? ",\n{\"at\": " : "{\"at\": ";
      integers(std::span(model_.control.at).subspan(c * n, n));
      value(c);
    }
    out_ += ']';
  }
  void separate() {
    out_ += "[\n";
    std::size_t c = 0;
    for (std::uint64_t t = 0; t < model_.tetrahedra.size(); ++t)
      for_each_tetrahedral_index(model_.degree, [&](const TetrahedralIndex& beta) {
        out_ += c > 0 ? ",\n{\"tetrahedron\": " : "{\"tetrahedron\": ";
        integer(t);
        out_ += ", \"beta\": ";
        integers(beta);
        value(c++);
      });
    out_ += ']';
  }

  const DmsModel& model_;
  std::string out_;
};

}  // namespace

std::string write_dms(const DmsModel& model) { return DmsWriter(model).write(); }

}  // namespace veritope
