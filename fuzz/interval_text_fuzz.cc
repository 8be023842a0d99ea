// SPDX-License-Identifier: LGPL-3.0-or-later
// The bytes are an interval literal: refused with the value that its contract says, or read to an
// interval that its exact text reads back; the bare and the decorated reader agree.
#include <cstdint>
#include <string_view>

#include "interval/relations.h"
#include "interval/text.h"
#include "robust/base/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace veritope;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Signalled<Interval> bare = text_to_interval(text);
  const Signalled<DecoratedInterval> decorated = text_to_decorated(text);
  const DecoratedInterval& d = decorated.value;
  VT_CHECK(bare.signal == Signal::kNone || bare.value.is_empty(), "a refused literal is empty");
  VT_CHECK(decorated.signal == Signal::kNone || d.is_nai(), "a refused literal is NaI");
  VT_CHECK(text_to_interval(exact_text(bare.value)).value == bare.value, "exact text reads back");
  const DecoratedInterval again = text_to_decorated(exact_text(d)).value;
  VT_CHECK(again.decoration() == d.decoration() && again.interval() == d.interval(),
           "exact text with a decoration reads back");
  if (bare.signal == Signal::kNone)
    VT_CHECK(decorated.signal == Signal::kNone && d.interval() == bare.value, "the readers agree");
  VT_CHECK(d.decoration() != Decoration::kCom || is_common(d.interval()), "com is bounded");
  return 0;
}
