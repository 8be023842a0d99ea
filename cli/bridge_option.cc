// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/bridge_option.h"

#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

std::string take_bridge(const std::string& text, BridgeChoice& choice) {
  if (text != "domain" && text != "space" && text != "none")
    return "must be domain, space or none, not " + text;
  choice.is_given = true;
  choice.is_wanted = text != "none";
  choice.are_in_space = text == "space";
  return "";
}

std::string take_alpha(const std::string& text, BridgeChoice& choice) {
  Rational alpha;
  if (read_exact_number(text, {}, alpha) != DecimalFault::kNone ||
      alpha.sign() != Sign::kPositive || alpha > Rational(1))
    return "needs a number over 0, at most 1, such as 1/2, not " + text;
  choice.alpha = nearest_double(alpha);
  choice.has_alpha = true;
  return "";
}

}  // namespace

std::string BridgeChoice::fault(bool has_model, bool has_skin) const {
  if (is_given && is_wanted && !has_model)
    return std::string("--bridge ") + (are_in_space ? "space" : "domain") +
           " needs --model, the solid to whose surface bridges lead";
  if (!has_alpha && !has_skin) return "";
  if (!is_wanted) return "--alpha and --skin shape bridges, and --bridge none builds none";
  return has_model ? "" : "--alpha and --skin shape bridges, which need --model";
}

void declare_bridge(OptionSet& set, BridgeChoice& choice, std::optional<double>& skin) {
  set.option(
      "--bridge", "KIND", [c = &choice](const std::string& text) { return take_bridge(text, *c); },
      "domain, space, none: to the model; --alpha A, --skin TAU");
  set.option(
      "--alpha", "A", [c = &choice](const std::string& text) { return take_alpha(text, *c); },
      "how far bridges go straight on, in units of the distance");
  set.length("--skin", "TAU", skin, "how near to the surface bridges end");
  set.hide("--alpha");
  set.hide("--skin");
}

}  // namespace veritope::cli
