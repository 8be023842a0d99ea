// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/relations.h"

namespace veritope {

Overlap overlap(const Interval& a, const Interval& b) {
  if (a.is_empty() && b.is_empty()) return Overlap::kBothEmpty;
  if (a.is_empty()) return Overlap::kFirstEmpty;
  if (b.is_empty()) return Overlap::kSecondEmpty;
  using internal::order_key;
  const std::int64_t al = order_key(a.lo()), ah = order_key(a.hi());
  const std::int64_t bl = order_key(b.lo()), bh = order_key(b.hi());
  if (ah < bl) return Overlap::kBefore;
  if (bh < al) return Overlap::kAfter;
  if (al == bl && ah == bh) return Overlap::kEquals;
  if (al == bl) return ah < bh ? Overlap::kStarts : Overlap::kStartedBy;
  if (ah == bh) return bl < al ? Overlap::kFinishes : Overlap::kFinishedBy;
  if (ah == bl) return Overlap::kMeets;
  if (bh == al) return Overlap::kMetBy;
  if (al < bl) return ah < bh ? Overlap::kOverlaps : Overlap::kContains;
  return ah < bh ? Overlap::kContainedBy : Overlap::kOverlappedBy;
}

}  // namespace veritope
