// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/spline_text_fuzz.cc: any bytes as each of the spline formats.
#include "fuzz/read_mutator.h"
#include "fuzz/spline_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  veritope::fuzz::check_spline_readers({data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  static constexpr std::string_view kWords[] = {"[OBJECT",
                                                "\"kind\": \"triangle\"",
                                                "\"degree\": 2",
                                                "[SURFACE BSPLINE",
                                                "[CURVE BEZIER",
                                                "[TRIVAR",
                                                "POWER",
                                                "[KV 0 0 1 1]",
                                                "[KVP",
                                                "E3",
                                                "P2",
                                                "[TRIMSRF",
                                                "[TRIMCRV",
                                                "[TRIMCRVSEG",
                                                "[MODEL",
                                                "[MDLTSRF",
                                                "[MDLTSEG",
                                                "[MDLLOOP",
                                                "]",
                                                "[POLYGON",
                                                "100 1 0 0",
                                                "200 1 0 0",
                                                "210 1 0 0",
                                                "250",
                                                "260",
                                                "261",
                                                "700 1 0 0",
                                                "1 100 100",
                                                "11",
                                                "10",
                                                "MFEM NURBS mesh v1.0",
                                                "dimension",
                                                "elements",
                                                "edges",
                                                "vertices",
                                                "knotvectors",
                                                "patches",
                                                "weights",
                                                "FiniteElementSpace",
                                                "controlpoints",
                                                "<Geometry type=\"TensorBSpline2\">",
                                                "<KnotVector degree=\"1\">",
                                                "</KnotVector>",
                                                "<coefs geoDim=\"3\">",
                                                "</coefs>",
                                                "</Geometry>",
                                                "<weights>",
                                                "<!--",
                                                "-->",
                                                "\"knots\"",
                                                "\"veritope-spline-1\"",
                                                "\"points\"",
                                                "null",
                                                "\"1/3\"",
                                                "\"0x1p-3\"",
                                                "1e400",
                                                "-1",
                                                "0",
                                                "nan",
                                                "\\u00e9"};
  return veritope::fuzz::mutate(data, size, max_size, seed, kWords, [](veritope::fuzz::Mutator& m) {
    m.pick(3) == 0 ? m.change_line(m.text().size()) : m.change_token(m.text().size());
  });
}
