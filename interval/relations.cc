// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/relations.h"

namespace veritope {

Overlap overlap(const Interval& a, const Interval& b) {
  if (a.is_empty() && b.is_empty()) return Overlap::kBothEmpty;
  if (a.is_empty()) return Overlap::kFirstEmpty;
  if (b.is_empty()) return Overlap::kSecondEmpty;
  using internal::key_of;
  const std::int64_t al = key_of(a.lo_bits()), ah = key_of(a.hi_bits());
  const std::int64_t bl = key_of(b.lo_bits()), bh = key_of(b.hi_bits());
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
