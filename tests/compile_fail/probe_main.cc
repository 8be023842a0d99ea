// SPDX-License-Identifier: LGPL-3.0-or-later
// What robust/base/fp_probe.h finds in a translation unit built with the flags under test.
#include <cstdio>

#include "robust/base/fp_probe.h"

int main() { std::printf("%u\n", veritope::internal::probe_fp_here()); }
