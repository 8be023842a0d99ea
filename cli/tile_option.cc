// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/tile_option.h"

#include <charconv>
#include <vector>

#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

std::string take_number(const std::string& value, Rational& to) {
  return read_exact_number(value, {}, to) == DecimalFault::kNone
             ? ""
             : "needs a number such as 1/8 or 0.125, not " + value;
}

std::string take_degree(const std::string& value, int& to) {
  const auto end = value.data() + value.size();
  const auto read = std::from_chars(value.data(), end, to);
  return read.ec == std::errc() && read.ptr == end ? "" : "needs a degree, 1 or 3, not " + value;
}

std::string take_key(const std::string& part, JackShape& shape) {
  const std::size_t equals = part.find('=');
  const std::string key = part.substr(0, equals),
                    value = equals == part.npos ? "" : part.substr(equals + 1);
  if (key == "node") return take_number(value, shape.node);
  if (key == "cap") return take_number(value, shape.cap);
  if (key == "degree") return take_degree(value, shape.degree);
  return "has no key " + key + "; a jack has node, cap and degree";
}

}  // namespace

std::string take_jack(const std::string& text, JackShape& shape) {
  const std::vector<std::string> parts = parts_of(text);
  if (parts[0] != "jack") return "needs a tile such as jack or jack,node=1/5, not " + text;
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (std::string why = take_key(parts[i], shape); !why.empty()) return why;
  const Result<MicroTile> tile = jack_tile(shape);
  return tile ? "" : "is not a tile: " + tile.error().message;
}

}  // namespace veritope::cli
