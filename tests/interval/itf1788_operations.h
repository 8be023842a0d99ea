// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/itf1788_operations.h: runs statements of ITF1788 with our operations.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interval/decorated_relations.h"
#include "interval/functions.h"
#include "interval/numeric.h"
#include "interval/reduction.h"
#include "interval/relations.h"
#include "interval/reverse.h"
#include "interval/text.h"
#include "tests/interval/itf1788_reader.h"

namespace veritope::itf1788 {

struct Outcome {
  std::vector<Value> results;
  Signal signal = Signal::kNone;
};
using Operands = std::vector<Value>;
using Operation = std::function<Outcome(const Operands&)>;

inline bool is_decorated(const Operands& in) {
  for (const Value& v : in)
    if (std::holds_alternative<DecoratedInterval>(v)) return true;
  return false;
}
template <typename T>
T interval_at(const Operands& in, std::size_t i) {
  if constexpr (std::is_same_v<T, DecoratedInterval>) {
    if (const Interval* bare = std::get_if<Interval>(&in[i])) return DecoratedInterval(*bare);
  }
  return std::get<T>(in[i]);
}
inline Value value(bool b) { return Word{b ? "true" : "false"}; }
template <typename T>
Value value(const T& v) {
  return v;
}

// f takes the intervals of the statement, all bare or all decorated.
template <std::size_t kCount, typename F>
Operation of(F f) {
  return [f](const Operands& in) {
    const auto call = [&]<typename T, std::size_t... I>(std::type_identity<T>,
                                                        std::index_sequence<I...>) {
      return Outcome{{value(f(interval_at<T>(in, I)...))}};
    };
    if (in.size() != kCount) throw std::invalid_argument("operands");
    constexpr auto all = std::make_index_sequence<kCount>();
    return is_decorated(in) ? call(std::type_identity<DecoratedInterval>{}, all)
                            : call(std::type_identity<Interval>{}, all);
  };
}
// f takes an interval and an integer.
template <typename F>
Operation with_integer(F f) {
  return [f](const Operands& in) {
    const auto n = static_cast<std::int64_t>(std::get<double>(in.at(1)));
    return is_decorated(in) ? Outcome{{f(interval_at<DecoratedInterval>(in, 0), n)}}
                            : Outcome{{f(interval_at<Interval>(in, 0), n)}};
  };
}

inline const char* overlap_name(Overlap o) {
  static const char* const names[] = {"bothEmpty", "firstEmpty",   "secondEmpty", "before",
                                      "meets",     "overlaps",     "starts",      "containedBy",
                                      "finishes",  "equals",       "finishedBy",  "contains",
                                      "startedBy", "overlappedBy", "metBy",       "after"};
  return names[static_cast<int>(o)];
}
inline const char* decoration_name(Decoration d) {
  switch (d) {
    case Decoration::kIll: return "ill";
    case Decoration::kTrv: return "trv";
    case Decoration::kDef: return "def";
    case Decoration::kDac: return "dac";
    case Decoration::kCom: break;
  }
  return "com";
}

#define VT_ITF_F(name, function)                           \
  {                                                        \
    name, of<1>([](const auto& x) { return function(x); }) \
  }
#define VT_ITF_F2(name, function)                                            \
  {                                                                          \
    name, of<2>([](const auto& x, const auto& y) { return function(x, y); }) \
  }
#define VT_ITF_UP(name, expression) \
  {                                 \
    name, of<1>([](const auto& x) { \
      const ScopedUpward upward;    \
      return expression;            \
    })                              \
  }
#define VT_ITF_UP2(name, expression)               \
  {                                                \
    name, of<2>([](const auto& x, const auto& y) { \
      const ScopedUpward upward;                   \
      return expression;                           \
    })                                             \
  }

inline void add_functions(std::map<std::string, Operation>& out) {
  out.merge(std::map<std::string, Operation>{
      VT_ITF_UP("pos", x),
      VT_ITF_UP("neg", -x),
      VT_ITF_UP("sqr", sqr(x)),
      VT_ITF_UP("recip", recip(x)),
      VT_ITF_UP("sqrt", sqrt(x)),
      VT_ITF_UP2("add", x + y),
      VT_ITF_UP2("sub", x - y),
      VT_ITF_UP2("mul", x * y),
      VT_ITF_UP2("div", x / y),
      VT_ITF_F("abs", abs),
      VT_ITF_F2("min", min),
      VT_ITF_F2("max", max),
      VT_ITF_F2("pow", pow),
      VT_ITF_F2("atan2", atan2),
      VT_ITF_F2("hypot", hypot),
      VT_ITF_F("exp", exp),
      VT_ITF_F("exp2", exp2),
      VT_ITF_F("exp10", exp10),
      VT_ITF_F("expm1", expm1),
      VT_ITF_F("log", log),
      VT_ITF_F("log2", log2),
      VT_ITF_F("log10", log10),
      VT_ITF_F("logp1", logp1),
      VT_ITF_F("sin", sin),
      VT_ITF_F("cos", cos),
      VT_ITF_F("tan", tan),
      VT_ITF_F("cot", cot),
      VT_ITF_F("sec", sec),
      VT_ITF_F("csc", csc),
      VT_ITF_F("asin", asin),
      VT_ITF_F("acos", acos),
      VT_ITF_F("atan", atan),
      VT_ITF_F("acot", acot),
      VT_ITF_F("sinh", sinh),
      VT_ITF_F("cosh", cosh),
      VT_ITF_F("tanh", tanh),
      VT_ITF_F("coth", coth),
      VT_ITF_F("sech", sech),
      VT_ITF_F("csch", csch),
      VT_ITF_F("asinh", asinh),
      VT_ITF_F("acosh", acosh),
      VT_ITF_F("atanh", atanh),
      VT_ITF_F("acoth", acoth),
      VT_ITF_F("cbrt", cbrt),
      VT_ITF_F("sign", sign_function),
      VT_ITF_F("ceil", ceil),
      VT_ITF_F("floor", floor),
      VT_ITF_F("trunc", trunc),
      VT_ITF_F("roundTiesToEven", round_ties_to_even),
      VT_ITF_F("roundTiesToAway", round_ties_to_away),
      VT_ITF_F2("intersection", intersection),
      VT_ITF_F2("convexHull", hull),
      VT_ITF_F2("cancelMinus", cancel_minus),
      VT_ITF_F2("cancelPlus", cancel_plus),
      {"fma", of<3>([](const auto& x, const auto& y, const auto& z) { return fma(x, y, z); })},
      {"pown", with_integer([](const auto& x, std::int64_t n) { return pown(x, n); })},
      {"rootn", with_integer([](const auto& x, std::int64_t n) { return rootn(x, n); })},
      {"mulRevToPair", [](const Operands& in) {
         const auto call = [&](const auto& b, const auto& c) {
           const auto pair = mul_rev_to_pair(b, c);
           return Outcome{{pair.first, pair.second}};
         };
         return is_decorated(in) ? call(interval_at<DecoratedInterval>(in, 0),
                                        interval_at<DecoratedInterval>(in, 1))
                                 : call(interval_at<Interval>(in, 0), interval_at<Interval>(in, 1));
       }}});
}

inline void add_numbers_and_relations(std::map<std::string, Operation>& out) {
  const auto empty = [](const auto& x) {
    if constexpr (requires { x.interval(); })
      return is_empty(x);
    else
      return x.is_empty();
  };
  const auto entire = [](const auto& x) {
    if constexpr (requires { x.interval(); })
      return is_entire(x);
    else
      return x.is_entire();
  };
  out.merge(std::map<std::string, Operation>{
      VT_ITF_F("inf", inf), VT_ITF_F("sup", sup), VT_ITF_F("mid", mid), VT_ITF_F("rad", rad), VT_ITF_F("wid", wid),
      VT_ITF_F("mag", mag), VT_ITF_F("mig", mig), VT_ITF_F("isCommonInterval", is_common),
      VT_ITF_F("isSingleton", is_singleton), VT_ITF_F2("subset", is_subset), VT_ITF_F2("interior", is_interior),
      VT_ITF_F2("disjoint", is_disjoint), VT_ITF_F2("less", is_less), VT_ITF_F2("strictLess", is_strictly_less),
      VT_ITF_F2("precedes", precedes), VT_ITF_F2("strictPrecedes", strictly_precedes),
      {"equal", of<2>([](const auto& x, const auto& y) { return x == y; })},
      {"isEmpty", of<1>(empty)}, {"isEntire", of<1>(entire)},
      {"isNaI", [](const Operands& in) { return Outcome{{value(interval_at<DecoratedInterval>(in, 0).is_nai())}}; }},
      {"overlap", of<2>([](const auto& x, const auto& y) { return Word{overlap_name(overlap(x, y))}; })},
      {"isMember", [](const Operands& in) {
         const double x = std::get<double>(in.at(0));
         return Outcome{{value(is_decorated(in) ? is_member(x, interval_at<DecoratedInterval>(in, 1))
                                                : is_member(x, interval_at<Interval>(in, 1)))}};
       }},
      {"midRad", [](const Operands& in) {
         if (in.size() != 1) throw std::invalid_argument("operands");
         const MidRad m = is_decorated(in) ? mid_rad(interval_at<DecoratedInterval>(in, 0))
                                           : mid_rad(interval_at<Interval>(in, 0));
         return Outcome{{m.mid, m.rad}};
       }}});
}

inline void add_constructors(std::map<std::string, Operation>& out) {
  out["b-numsToInterval"] = [](const Operands& in) {
    const auto r = nums_to_interval(std::get<double>(in.at(0)), std::get<double>(in.at(1)));
    return Outcome{{r.value}, r.signal};
  };
  out["d-numsToInterval"] = [](const Operands& in) {
    const auto r = nums_to_decorated(std::get<double>(in.at(0)), std::get<double>(in.at(1)));
    return Outcome{{r.value}, r.signal};
  };
  out["b-textToInterval"] = [](const Operands& in) {
    const auto r = text_to_interval(std::get<Text>(in.at(0)).text);
    return Outcome{{r.value}, r.signal};
  };
  out["d-textToInterval"] = [](const Operands& in) {
    const auto r = text_to_decorated(std::get<Text>(in.at(0)).text);
    return Outcome{{r.value}, r.signal};
  };
  out["newDec"] = [](const Operands& in) {
    return Outcome{{DecoratedInterval(std::get<Interval>(in.at(0)))}};
  };
  out["setDec"] = [](const Operands& in) {
    const auto r = set_decoration(std::get<Interval>(in.at(0)),
                                  decoration_named(std::get<Word>(in.at(1)).text));
    return Outcome{{r.value}, r.signal};
  };
  out["intervalPart"] = [](const Operands& in) {
    const auto r = interval_part(std::get<DecoratedInterval>(in.at(0)));
    return Outcome{{r.value}, r.signal};
  };
  out["decorationPart"] = [](const Operands& in) {
    return Outcome{{Word{decoration_name(std::get<DecoratedInterval>(in.at(0)).decoration())}}};
  };
}

inline void add_reductions(std::map<std::string, Operation>& out) {
  const auto one = [](double (*f)(std::span<const double>)) {
    return [f](const Operands& in) { return Outcome{{f(std::get<Numbers>(in.at(0)))}}; };
  };
  out["sum_nearest"] = one(sum_nearest);
  out["sum_abs_nearest"] = one(sum_abs_nearest);
  out["sum_sqr_nearest"] = one(sum_sqr_nearest);
  out["dot_nearest"] = [](const Operands& in) {
    return Outcome{{dot_nearest(std::get<Numbers>(in.at(0)), std::get<Numbers>(in.at(1)))}};
  };
}

// Reverse operations have no decoration of their own: kTrv, or NaI.
template <typename F>
Operation reverse(F f) {
  return [f](const Operands& in) {
    std::vector<Interval> bare;
    std::int64_t n = 0;
    bool nai = false;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (const double* number = std::get_if<double>(&in[i])) {
        n = static_cast<std::int64_t>(*number);
        continue;
      }
      const auto d = interval_at<DecoratedInterval>(in, i);
      nai = nai || d.is_nai();
      bare.push_back(d.interval());
    }
    const Interval out = f(bare, n);
    if (!is_decorated(in)) return Outcome{{out}};
    return Outcome{{nai ? DecoratedInterval::nai() : DecoratedInterval(out, Decoration::kTrv)}};
  };
}
inline Interval last_or_entire(const std::vector<Interval>& x, std::size_t count) {
  return x.size() > count ? x[count] : Interval::entire();
}

inline void add_reverse(std::map<std::string, Operation>& out) {
  using Reverse = Interval (*)(const Interval&, const Interval&);
  const std::pair<const char*, Reverse> unary[] = {{"sqrRev", sqr_rev},   {"absRev", abs_rev},
                                                   {"coshRev", cosh_rev}, {"sinRev", sin_rev},
                                                   {"cosRev", cos_rev},   {"tanRev", tan_rev}};
  for (const auto& [name, f] : unary)
    for (const char* suffix : {"", "Bin"})
      out[std::string(name) + suffix] =
          reverse([f = f](const std::vector<Interval>& x, std::int64_t) {
            return f(x.at(0), last_or_entire(x, 1));
          });
  for (const char* name : {"pownRev", "pownRevBin"})
    out[name] = reverse([](const std::vector<Interval>& x, std::int64_t n) {
      return pown_rev(x.at(0), n, last_or_entire(x, 1));
    });
  using Reverse2 = Interval (*)(const Interval&, const Interval&, const Interval&);
  const std::pair<const char*, Reverse2> binary[] = {
      {"mulRev", mul_rev}, {"mulRevTen", mul_rev}, {"powRev1", pow_rev1}, {"powRev2", pow_rev2}};
  for (const auto& [name, f] : binary)
    out[name] = reverse([f = f](const std::vector<Interval>& x, std::int64_t) {
      return f(x.at(0), x.at(1), last_or_entire(x, 2));
    });
}

inline const std::map<std::string, Operation>& operations() {
  static const std::map<std::string, Operation> all = [] {
    std::map<std::string, Operation> out;
    add_functions(out);
    add_numbers_and_relations(out);
    add_constructors(out);
    add_reductions(out);
    add_reverse(out);
    return out;
  }();
  return all;
}

inline bool same(const Value& got, const Value& want) {
  if (got.index() != want.index()) return false;
  if (const auto* d = std::get_if<DecoratedInterval>(&got)) {
    const auto& e = std::get<DecoratedInterval>(want);
    return d->decoration() == e.decoration() && d->interval() == e.interval();
  }
  if (const auto* x = std::get_if<Interval>(&got)) return *x == std::get<Interval>(want);
  if (const auto* w = std::get_if<Word>(&got)) return w->text == std::get<Word>(want).text;
  if (const auto* v = std::get_if<double>(&got)) {
    const double e = std::get<double>(want);  // NaN equals NaN; -0 is not 0
    return internal::is_nan(*v)
               ? internal::is_nan(e)
               : std::bit_cast<std::uint64_t>(*v) == std::bit_cast<std::uint64_t>(e);
  }
  return false;
}

inline std::string text_of(const Value& v) {
  if (const auto* d = std::get_if<DecoratedInterval>(&v)) return exact_text(*d);
  if (const auto* x = std::get_if<Interval>(&v)) return exact_text(*x);
  if (const auto* w = std::get_if<Word>(&v)) return w->text;
  if (const auto* n = std::get_if<double>(&v)) return std::to_string(*n);
  return "?";
}

/// Our result is a proper subset of the interval that the statement asks for, with the same decoration.
inline bool is_narrower(const Statement& s) {
  const Operands got = operations().at(s.operation)(s.operands).results;
  const auto ours = interval_at<DecoratedInterval>(got, 0),
             theirs = interval_at<DecoratedInterval>(s.results, 0);
  return is_subset(ours, theirs) && !(ours == theirs) &&
         (!is_decorated(got) || ours.decoration() == theirs.decoration());
}

/// Nothing if the statement passes; else what happened instead.
inline std::optional<std::string> failure(const Statement& s) {
  const auto operation = operations().find(s.operation);
  if (operation == operations().end()) return "no such operation";
  Outcome got;
  try {
    got = operation->second(s.operands);
  } catch (const std::exception& e) {
    return std::string("the operands do not fit: ") + e.what();
  }
  std::string text;
  bool equal =
      got.results.size() == s.results.size() && got.signal == s.signal && !s.unknown_signal;
  for (std::size_t i = 0; i < got.results.size(); ++i) {
    equal = equal && same(got.results[i], s.results[i]);
    text += text_of(got.results[i]) + " ";
  }
  if (equal) return std::nullopt;
  return "gave " + text + "with signal " + std::to_string(static_cast<int>(got.signal));
}

}  // namespace veritope::itf1788
