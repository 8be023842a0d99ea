// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "cli/dms_render.h"
#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

std::vector<std::string> split_at(char separator, const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    out.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// Exact numbers that commas part; nothing if there are not `count` of them.
std::optional<std::vector<Rational>> exact_numbers(const std::string& text, std::size_t count) {
  std::vector<Rational> out;
  for (const std::string& word : split_at(',', text))
    if (read_exact_number(word, {}, out.emplace_back()) != DecimalFault::kNone) return std::nullopt;
  return out.size() == count ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::vector<double>> finite_numbers(const std::string& text, std::size_t count) {
  const auto exact = exact_numbers(text, count);
  if (!exact) return std::nullopt;
  std::vector<double> out;
  for (const Rational& x : *exact) {
    out.push_back(nearest_double(x));
    if (!std::isfinite(out.back())) return std::nullopt;
  }
  return out;
}

constexpr std::array<std::pair<std::string_view, DmsMode>, 4> kModes = {
    {{"xray", DmsMode::kXray},
     {"volume", DmsMode::kVolume},
     {"slice", DmsMode::kSlice},
     {"iso", DmsMode::kIso}}};

std::string take_mode(const std::string& text, std::optional<DmsMode>& mode) {
  const auto* const found =
      std::find_if(kModes.begin(), kModes.end(), [&](const auto& m) { return m.first == text; });
  if (found == kModes.end()) return "must be xray, volume, slice or iso, not " + text;
  mode = found->second;
  return "";
}

std::string take_exact(const std::string& text, std::optional<Rational>& target) {
  auto numbers = exact_numbers(text, 1);
  if (!numbers) return "must be a number, not " + text;
  target = std::move((*numbers)[0]);
  return "";
}

std::string take_width(const std::string& text, std::optional<Rational>& target) {
  const std::string wrong = take_exact(text, target);
  return wrong.empty() && target->sign() != Sign::kPositive ? "must be a number > 0" : wrong;
}

std::string take_space(const std::string& text, std::optional<bool>& in_domain) {
  if (text != "domain" && text != "solid") return "must be domain or solid, not " + text;
  in_domain = text == "domain";
  return "";
}

std::string take_plane(const std::string& text, std::optional<DmsSlicePlane>& plane) {
  auto numbers = exact_numbers(text, 4);
  if (!numbers) return "needs four numbers A,B,C,D, not " + text;
  std::vector<Rational>& n = *numbers;
  if (n[0].sign() == Sign::kZero && n[1].sign() == Sign::kZero && n[2].sign() == Sign::kZero)
    return "is no plane: " + text;
  plane = DmsSlicePlane{{std::move(n[0]), std::move(n[1]), std::move(n[2])}, std::move(n[3])};
  return "";
}

std::string take_range(const std::string& text, std::optional<std::array<double, 2>>& range) {
  const auto numbers = finite_numbers(text, 2);
  if (!numbers || !((*numbers)[0] < (*numbers)[1]))
    return "needs two numbers LO,HI, the first one less, not " + text;
  range = {(*numbers)[0], (*numbers)[1]};
  return "";
}

// "value:red,green,blue,extinction"
std::string take_node(const std::string& text, std::vector<TransferNode>& nodes) {
  const std::vector<std::string> halves = split_at(':', text);
  const auto value =
      halves.size() == 2 ? finite_numbers(halves[0], 1) : std::optional<std::vector<double>>();
  const auto rest =
      halves.size() == 2 ? finite_numbers(halves[1], 4) : std::optional<std::vector<double>>();
  if (!value || !rest) return "needs nodes V:R,G,B,E between semicolons, not '" + text + "'";
  TransferNode node{(*value)[0], {(*rest)[0], (*rest)[1], (*rest)[2]}, (*rest)[3]};
  for (const double c : node.colour)
    if (c < 0 || c > 255) return "has a colour that is not from 0 to 255: '" + text + "'";
  if (node.extinction < 0) return "has an extinction below 0: '" + text + "'";
  if (!nodes.empty() && node.value < nodes.back().value)
    return "has values that do not ascend: '" + text + "'";
  nodes.push_back(node);
  return "";
}

std::string take_transfer(const std::string& text,
                          std::optional<std::vector<TransferNode>>& transfer) {
  std::vector<TransferNode> nodes;
  for (const std::string& node : split_at(';', text))
    if (std::string wrong = take_node(node, nodes); !wrong.empty()) return wrong;
  transfer = std::move(nodes);
  return "";
}

struct Given {
  const char* name;
  bool is_given;
  bool fits;  // the mode
};

std::array<Given, 10> given_options(const DmsRenderOptions& o) {
  const auto is = [&o](DmsMode mode) { return o.mode == mode; };
  return {{{"--attribute", o.attribute.has_value(), true},
           {"--level", o.level.has_value(), is(DmsMode::kIso)},
           {"--within", o.within.has_value(), is(DmsMode::kIso)},
           {"--space", o.in_domain.has_value(), !is(DmsMode::kXray)},
           {"--plane", o.plane.has_value(), is(DmsMode::kSlice)},
           {"--transfer", o.transfer.has_value(), is(DmsMode::kVolume)},
           {"--range", o.range.has_value(), is(DmsMode::kSlice) || (!o.mode && o.attribute)},
           {"--absorption", o.absorption.has_value(), is(DmsMode::kXray)},
           {"--step", o.step.has_value(), is(DmsMode::kVolume)},
           {"--isolines", o.isolines.has_value(), is(DmsMode::kSlice)}}};
}

}  // namespace

std::string mode_name(DmsMode mode) {
  return std::string(kModes.at(static_cast<std::size_t>(mode)).first);
}

void declare_dms_render(OptionSet& set, DmsRenderOptions& o) {
  set.option(
      "--mode", "M", [&o](const std::string& t) { return take_mode(t, o.mode); },
      "vdms: xray, volume, slice, iso; with --attribute A,\n--level, --within, --space, --plane, "
      "--transfer, ...");
  set.text("--attribute", o.attribute, "the attribute that is drawn", "A");
  set.option(
      "--level", "C", [&o](const std::string& t) { return take_exact(t, o.level); },
      "iso: the value of the attribute on the surface");
  set.option(
      "--within", "E", [&o](const std::string& t) { return take_width(t, o.within); },
      "iso: cells that the surface crosses are at most as wide");
  set.option(
      "--space", "S", [&o](const std::string& t) { return take_space(t, o.in_domain); },
      "iso, boundary: solid (default) or domain;\nvolume, slice: domain (default) or solid");
  set.option(
      "--plane", "A,B,C,D", [&o](const std::string& t) { return take_plane(t, o.plane); },
      "slice: the plane A x + B y + C z = D");
  set.option(
      "--transfer", "T", [&o](const std::string& t) { return take_transfer(t, o.transfer); },
      "volume: colours and opacities of values");
  set.option(
      "--range", "LO,HI", [&o](const std::string& t) { return take_range(t, o.range); },
      "slice: the values of the first and the last colour");
  set.length("--absorption", "K", o.absorption, "xray: integrals are multiplied with it",
             "a factor");
  set.length("--step", "H", o.step, "volume: the distance of samples");
  set.number("--isolines", o.isolines, {0, 1000}, "slice: the number of isolines");
  for (const Given& given : given_options(o)) set.hide(given.name);
}

std::string dms_render_option(const DmsRenderOptions& options) {
  if (options.mode) return "--mode";
  for (const Given& given : given_options(options))
    if (given.is_given) return given.name;
  return "";
}

std::string dms_render_contradiction(const DmsRenderOptions& options) {
  if (options.mode && !options.attribute)
    return "--attribute A is required with --mode, the name of what is drawn";
  for (const Given& given : given_options(options)) {
    if (!given.is_given || given.fits) continue;
    if (given.name == std::string("--space"))
      return "--space: pictures of mode " + mode_name(*options.mode) +
             " are of the domain, in which alone rays have integrals";
    if (options.mode) return std::string(given.name) + " is not for this mode";
    // Without --mode colours of the boundary have a range.
    const bool is_range = given.name == std::string("--range");
    return std::string(given.name) + (is_range ? " needs --attribute" : " needs --mode");
  }
  if (options.mode == DmsMode::kIso && !options.level)
    return "--level C is required with --mode iso, the value of the attribute";
  return "";
}

std::array<std::size_t, 2> dms_picture_size(const DmsRenderOptions& options) {
  if (options.mode == DmsMode::kXray || options.mode == DmsMode::kVolume) return {256, 256};
  return {1200, 900};
}

}  // namespace veritope::cli
