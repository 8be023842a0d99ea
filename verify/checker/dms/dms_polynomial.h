// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_polynomial.h: Bernstein coefficients of s on simplices on which it is one polynomial, by the recurrences of the
// simplex splines with polynomials in the place of numbers.
#pragma once
#include "dms_values.h"

struct DmsPolynomials {
  DmsPolynomials(int n, size_t corners);

  // All coefficients, three coordinates each, in the order of dms_indices, of the sum of N_gamma L_gamma over these
  // terms. REQUIRES that each N_gamma is one polynomial on the simplex.
  // inside: null, or an inner point of a tetrahedron of whose face the simplex is a part
  std::vector<Ratio> coefficients(const DmsModel& model,
                                  const std::vector<const DmsPoint*>& corners,
                                  const DmsPoint* inside, const std::vector<DmsTerm>& terms,
                                  Units* units) const;

 private:
  friend struct DmsSum;
  const int n;
  const size_t corners;
  std::vector<std::vector<DmsIndex>>
      indices;  // of each degree; the last number is 0 if there are three corners
  std::vector<std::vector<size_t>>
      products;  // of each degree: the place of each index raised at each corner
};
