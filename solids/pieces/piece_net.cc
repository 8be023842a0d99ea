// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/piece_net_quarters_internal.h"

namespace veritope::internal {

template void quarter_tensor(const FormShape& shape, const double* net, double* const children[4]);
template void quarter_triangle(int degree, const double* net, double* const children[4]);

}  // namespace veritope::internal
