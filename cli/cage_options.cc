// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/cage_options.h"

#include <algorithm>

#include "cli/did_you_mean.h"
#include "cli/option_groups.h"
#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

constexpr std::array<const char*, 5> kKinds = {"box", "radial", "hull", "split", "fit"};

std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    out.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// Exactly N numbers with commas between them; `form` shows them: "X,Y,Z".
template <std::size_t N>
TakeText exact_numbers(std::optional<std::array<Rational, N>>& target, const char* count,
                       const char* form) {
  return [&target, count, form](const std::string& text) -> std::string {
    const std::vector<std::string> tokens = tokens_of(text);
    if (tokens.size() != N) return std::string("needs ") + count + " " + form + ", not " + text;
    target.emplace();
    for (std::size_t k = 0; k < N; ++k)
      if (read_exact_number(tokens[k], {}, (*target)[k]) != DecimalFault::kNone)
        return std::string("needs decimals, fractions or hexadecimal numbers ") + form +
               ", and has '" + tokens[k] + "'";
    return "";
  };
}
TakeText exact_number(std::optional<Rational>& target) {
  return [&target](const std::string& text) -> std::string {
    if (read_exact_number(text, {}, target.emplace()) == DecimalFault::kNone) return "";
    return "needs a decimal, fraction or hexadecimal number, not " + text;
  };
}
TakeText not_negative(std::optional<Rational>& target) {
  return [&target](const std::string& text) -> std::string {
    if (std::string wrong = exact_number(target)(text); !wrong.empty()) return wrong;
    return target->sign() == Sign::kNegative ? "must not be negative, and is " + text : "";
  };
}

TakeText counts_from_1(std::optional<std::array<std::uint64_t, 3>>& target, std::uint64_t most,
                       const char* form) {
  return [&target, most, form](const std::string& text) -> std::string {
    const std::vector<std::string> tokens = tokens_of(text);
    const std::string needed = std::string("needs three numbers ") + form + " from 1 to " +
                               std::to_string(most) + ", not " + text;
    if (tokens.size() != 3) return needed;
    target.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string& token = tokens[k];
      if (token.empty() || token.size() > 6 || token.find_first_not_of("0123456789") != token.npos)
        return needed;
      (*target)[k] = std::stoull(token);
      if ((*target)[k] < 1 || (*target)[k] > most) return needed;
    }
    return "";
  };
}

std::optional<std::size_t> axis_named(char name) {
  if (name < 'u' || name > 'w') return std::nullopt;
  return static_cast<std::size_t>(name - 'u');
}

std::string take_parameter(const std::string& text, std::optional<AxisParameter>& at) {
  const std::string wrong = "needs an axis and a parameter, such as u=1/2, not " + text;
  if (text.size() < 3 || text[1] != '=' || !axis_named(text[0])) return wrong;
  at.emplace().axis = *axis_named(text[0]);
  const bool is_read = read_exact_number(text.substr(2), {}, at->at) == DecimalFault::kNone;
  return is_read ? "" : wrong;
}

std::string take_face(const std::string& text, std::optional<FaceName>& face) {
  if (text.size() != 2 || !axis_named(text[0]) || (text[1] != '0' && text[1] != '1'))
    return "needs a face, u0, u1, v0, v1, w0 or w1, not " + text;
  face = FaceName{*axis_named(text[0]), text[1] == '1'};
  return "";
}

// An option, whether it is given, and the kinds that it is for.
struct KindOption {
  const char* name;
  bool is_given;
  std::vector<CageKind> kinds;
};

std::vector<KindOption> kind_options(const CageOptions& o) {
  using enum CageKind;
  return {{"--around", o.around.has_value(), {kBox, kRadial, kHull, kFit}},
          {"--margin", o.margin.has_value(), {kBox, kRadial, kHull, kFit}},
          {"--min", o.min.has_value(), {kBox}},
          {"--max", o.max.has_value(), {kBox}},
          {"--degrees", o.degrees.has_value(), {kBox, kHull, kFit}},
          {"--spans", o.spans.has_value(), {kBox, kHull, kFit}},
          {"--point", o.point.has_value(), {kRadial}},
          {"--axis", o.axis.has_value(), {kRadial}},
          {"--start", o.start.has_value(), {kRadial}},
          {"--inner", o.inner.has_value(), {kRadial}},
          {"--outer", o.outer.has_value(), {kRadial}},
          {"--height", o.height.has_value(), {kRadial}},
          {"--sector", o.sector.has_value(), {kRadial}},
          {"--field", o.field.has_value(), {kFit}},
          {"--of", o.of.has_value(), {kSplit}},
          {"--entity", o.entity.has_value(), {kSplit}},
          {"--at", o.at.has_value(), {kSplit}},
          {"--open", o.open.has_value(), {kSplit}},
          {"--from", o.from.has_value(), {kSplit}},
          {"--low", o.low.has_value(), {kSplit}},
          {"--high", o.high.has_value(), {kSplit}}};
}

std::string foreign_option(const CageOptions& o) {
  for (const KindOption& option : kind_options(o)) {
    if (!option.is_given || std::ranges::find(option.kinds, *o.kind) != option.kinds.end())
      continue;
    std::string kinds;
    for (std::size_t i = 0; i < option.kinds.size(); ++i)
      kinds += (i == 0                        ? ""
                : i + 1 < option.kinds.size() ? ", "
                                              : " and ") +
               std::string(cage_kind_name(option.kinds[i]));
    return std::string(option.name) + " is for " + kinds + ", not for " + cage_kind_name(*o.kind);
  }
  return "";
}

// What a box or a radial cage is made from.
std::string wrong_size(const CageOptions& o, bool has_first, bool has_second, bool has_any,
                       const char* both) {
  if (o.around && has_any) return std::string("--around excludes ") + both;
  if (!o.around && !(has_first && has_second))
    return std::string(cage_kind_name(*o.kind)) + " needs --around M, or " + both;
  return "";
}

std::string wrong_split(const CageOptions& o) {
  if (!o.of) return "split needs --of C.vjson, the cage to be split";
  if (!o.at) return "split needs --at, such as --at u=1/2";
  const bool has_rest = o.from && (o.low || o.high);
  if (o.open && !has_rest) return "--open needs --from, and --low or --high";
  if (!o.open && (o.from || o.low || o.high)) return "--from, --low and --high need --open";
  return "";
}

std::string wrong_fit(const CageOptions& o) {
  if (!o.field) return "fit needs --field F.csv, the directions to follow";
  return o.margin && o.margin->sign() == Sign::kZero ? "--margin of a fit must be positive" : "";
}

std::string wrong_options(const CageOptions& o) {
  if (!o.output) return "-o C.vjson is required, the file of the cells";
  if (*o.output != "-" && !o.output->ends_with(".vjson"))
    return "the name " + *o.output + " does not end in .vjson";
  if (std::string wrong = foreign_option(o); !wrong.empty()) return wrong;
  if (o.output == "-" && o.json == "-")
    return "--output and --json would both write standard output";
  if (o.around == "-" || o.of == "-" || o.field == "-")
    return "- is not read: the model needs a file";
  if (o.margin && !o.around && *o.kind != CageKind::kFit) return "--margin needs --around";
  switch (*o.kind) {
    case CageKind::kBox:
      return wrong_size(o, o.min.has_value(), o.max.has_value(), o.min || o.max, "--min and --max");
    case CageKind::kRadial:
      return wrong_size(o, o.outer.has_value(), o.height.has_value(), o.outer || o.height,
                        "--outer and --height");
    case CageKind::kHull:
      if (!o.around) return "hull needs --around M";
      return o.margin && o.margin->sign() == Sign::kZero ? "--margin of a hull must be positive"
                                                         : "";
    case CageKind::kSplit: return wrong_split(o);
    case CageKind::kFit: return wrong_fit(o);
  }
  return "";
}

std::string take_kind(const std::string& text, std::optional<CageKind>& kind) {
  for (std::size_t i = 0; i < kKinds.size(); ++i)
    if (text == kKinds[i]) {
      kind = static_cast<CageKind>(i);
      return "";
    }
  return "must be box, radial, hull, split or fit, not " + text +
         did_you_mean(text, {kKinds.begin(), kKinds.end()});
}

}  // namespace

const char* cage_kind_name(CageKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

CageOptions::CageOptions() { reading.jobs = default_jobs(); }

Rational CageOptions::margin_part() const { return margin ? *margin : Rational(1) / Rational(20); }

CageGrid CageOptions::grid(std::uint64_t default_spans, int default_degree) const {
  CageGrid out;
  out.degrees.fill(default_degree);
  for (std::size_t k = 0; k < 3; ++k) {
    if (degrees) out.degrees[k] = static_cast<int>((*degrees)[k]);
    out.spans[k] = spans ? (*spans)[k] : default_spans;
  }
  return out;
}

RadialShape CageOptions::shape() const {
  RadialShape out;
  if (point) out.axis.point = *point;
  if (axis) out.axis.direction = *axis;
  out.start = start;
  if (inner) out.inner = *inner;
  if (outer) out.outer = *outer;
  if (height) {
    out.low = (*height)[0];
    out.high = (*height)[1];
  }
  out.degrees = sector;
  return out;
}

CageSplit CageOptions::split() const {
  CageSplit out{entity.value_or(0), at->axis, at->at, {}};
  if (open)
    out.crack = CageCrack{open->axis, open->is_at_end, *from, low.value_or(CellPoint{}),
                          high.value_or(CellPoint{})};
  return out;
}

void declare_cage_options(OptionSet& set, CageOptions& o) {
  const auto hidden = [&](const char* name, const char* type, TakeText take, const char* help) {
    set.option(name, type, std::move(take), help);
    set.hide(name);  // another line of the help names it
  };
  set.operand(
      "KIND", [&o](const std::string& text) { return take_kind(text, o.kind); },
      "box, radial, hull, split, or fit --field F.csv");
  set.output("-o,--output", o.output, "write the cells: a spline file, .vjson");
  set.text("--around", o.around, "a mesh or splines that the cage contains", "M");
  set.option("--margin", "R", not_negative(o.margin), "grow by R times M's diagonal (1/20)");
  set.option("--min", "X,Y,Z", exact_numbers(o.min, "three numbers", "X,Y,Z"),
             "box: a corner; --max X,Y,Z: the opposite one");
  hidden("--max", "X,Y,Z", exact_numbers(o.max, "three numbers", "X,Y,Z"), "the opposite corner");
  set.option("--degrees", "P,Q,R", counts_from_1(o.degrees, kMaxCellDegree, "P,Q,R"),
             "box, hull, fit: degrees; --spans A,B,C");
  hidden("--spans", "A,B,C", counts_from_1(o.spans, kMaxCageSpans, "A,B,C"), "knot spans");
  set.option("--outer", "R", not_negative(o.outer), "radial: radius; --inner R (0); --height A,B");
  hidden("--inner", "R", not_negative(o.inner), "the radius of a hole");
  hidden("--height", "A,B", exact_numbers(o.height, "two numbers", "A,B"), "along the axis");
  set.option("--axis", "X,Y,Z", exact_numbers(o.axis, "three numbers", "X,Y,Z"),
             "radial: direction (0,0,1); --point, --start X,Y,Z");
  hidden("--point", "X,Y,Z", exact_numbers(o.point, "three numbers", "X,Y,Z"), "on the axis");
  hidden("--start", "X,Y,Z", exact_numbers(o.start, "three numbers", "X,Y,Z"), "angle 0");
  set.option("--sector", "DEGREES", exact_number(o.sector), "radial: its angle (a full turn)");
  set.text("--field", o.field, "fit: the directions to follow", "F.csv");
  set.hide("--field");
  set.text("--of", o.of, "split: the cage; --entity I: its cell (0)", "C.vjson");
  set.number("--entity", o.entity, {0, kMost32 - 1}, "the cell");
  set.hide("--entity");
  set.option(
      "--at", "u=T", [&o](const std::string& text) { return take_parameter(text, o.at); },
      "split: cut it there, into cells that stay glued");
  set.option(
      "--open", "FACE", [&o](const std::string& text) { return take_face(text, o.open); },
      "split: --from T on, by --low, --high X,Y,Z");
  hidden("--from", "T", exact_number(o.from), "where the crack begins");
  hidden("--low", "X,Y,Z", exact_numbers(o.low, "three numbers", "X,Y,Z"), "how far it opens");
  hidden("--high", "X,Y,Z", exact_numbers(o.high, "three numbers", "X,Y,Z"), "how far it opens");
  declare_json(set, o.json, "write what was made");
  declare_jobs(set, o.reading.jobs);
  declare_reading(set, o.reading);
  set.hide("--as-indexed");
  set.rule([&o] { return wrong_options(o); });
}

}  // namespace veritope::cli
