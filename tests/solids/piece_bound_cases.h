// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/piece_bound_cases.h: inputs that use most of each bound of solids/pieces/piece_bounds.h, printed
// by piece_bound_search.
#pragma once
#include "tests/support/piece_bound_subjects.h"

namespace veritope::piece_bounds {

// Every subject has a case that uses more than this.
inline constexpr double kLeastShare = 0.4;

// clang-format off
inline const std::vector<BoundCase> kBoundCases{
    // uses 0.500
    {"side", 0, 0, Rounding::kNearest,
     {0x1.f7fffefecc4f3p+11, 0x1.000e1fe583eeap+8, 0x1.ffffffffffffdp+1, -0x1.0af1dbe63754ap+2,
      0x1.00427386f5155p+1, 0x1.fffffff9d539dp+3, 0x1.a4d83b8e812abp+3, -0x1.df94f29619e05p+1,
      -0x1.0000000001515p+57, -0x1.05e0204b017cp+13}},
    // uses 0.333
    {"hull", 0, 0, Rounding::kNearest,
     {-0x1.23cf5066fp-16, 0x1.0fffe3894dedbp+1, -0x1.fff151ab5c0dp-4}},
    // uses 0.456
    {"rational_hull", 0, 0, Rounding::kNearest,
     {0x1.188acef31c916p+39, 0x1.0073ffea0e9dap+0, 0x1.000000a23316dp+2, 0x1.f59face5831ffp-8,
      0x1.0015752234801p+25}},
    // uses 0.373
    {"projected", 0, 0, Rounding::kNearest,
     {0x1.fe533e9340cf8p-1, -0x1.00057ffcf91b1p-34, -0x1.ced7ad74b003bp-15, 0x1.e4f8d5f87277ep-1,
      -0x1.0740b46a817d9p-36, 0x1.fff1664910cfcp+1, 0x1.006eb349129a6p+2, 0x1.1278a58ea9e2fp+2,
      -0x1.ffdadbea029a9p-2, -0x1.ffffd35579b68p-2, 0x1.0000000000b97p+1, -0x1.ffffff9eceb5p-3,
      -0x1.0000d65706538p-2}},
    // uses 0.229
    {"turned", 0, 0, Rounding::kNearest,
     {0x1.0984c148f1d9ep+79, 0x1.ffb333ead6a92p+26, 0x1.001d4931529bfp+73, 0x1.000000003bc97p+47,
      0x1.fffffebce2a2fp+1, 0x1.094de4a815dfbp-48, 0x1.0033a0770cd44p-31, -0x1.7fdb640e79b64p-51,
      -0x1.fffffb1ac2917p+1, 0x1.0000000040d4cp+2, -0x1.07f0033def21fp-10, 0x1.fffffffff726fp+32,
      0x1.001c1f29e184dp+33}},
    // uses 0.437
    {"tensor", 1, 1, Rounding::kNearest,
     {0x1.0000000000002p-1, 0x1.0000000000002p-1, 0x1.0000000000001p-1, 0x1.fffffffffffffp-2}},
    // uses 0.346
    {"tensor", 3, 3, Rounding::kNearest,
     {0x1.000000000001bp-1, 0x1.0000000000005p-1, 0x1.0000000000004p-1, 0x1.000000000001p-1,
      0x1.0000000000017p-1, 0x1.000000000002p-1, 0x1.0000000000002p-1, 0x1.000000000001ep-1,
      0x1.000000000001bp-1, 0x1.0000000000016p-1, 0x1.0000000000013p-1, 0x1.0000000000007p-1,
      0x1.0000000000006p-1, 0x1.0000000000017p-1, 0x1.0000000000016p-1, 0x1.000000000000ap-1}},
    // uses 0.500
    {"triangle", 1, 0, Rounding::kNearest,
     {0x1p-1, 0x1.0000000000001p-1, 0x1.ffffffffffffdp-2}},
    // uses 0.396
    {"triangle", 3, 0, Rounding::kNearest,
     {0x1.ffffffffffffdp-2, 0x1.0000000000002p-1, 0x1.ffffffffffffep-2, 0x1.ffffffffffffdp-2,
      0x1.0000000000002p-1, 0x1p-1, 0x1.ffffffffffffcp-2, 0x1.0000000000001p-1,
      0x1.0000000000002p-1, 0x1.fffffffffffffp-2}},
    // uses 1.000
    {"side", 0, 0, Rounding::kUpward,
     {0x1.fe3a019c3e546p+88, 0x1.0c93421e00a2ep-39, 0x1.0000000000001p+118, -0x1.3415a309fc2cep+8,
      -0x1.d151a1b3436c3p-99, 0x1p+192, -0x1.0000000201e71p+0, -0x1.fffffffffc37cp-1,
      -0x1.f63e6ad05d2dp-39, 0x1.00073aad180a4p+19}},
    // uses 0.600
    {"hull", 0, 0, Rounding::kUpward,
     {0x1.006825fb3939p-45, 0x1.3ffffffffebfcp+107, 0x1.f6d74562353a7p-86}},
    // uses 0.864
    {"rational_hull", 0, 0, Rounding::kUpward,
     {0x1.0000000000017p+2, 0x1.35091b862a15dp+49, 0x1.0198a385d6e82p+9, 0x1.a704cb5fffc3p-15,
      0x1.29118f5839c17p-171}},
    // uses 0.427
    {"projected", 0, 0, Rounding::kUpward,
     {0x1.23a729248525bp-13, -0x1.89bbec0ca25edp-72, 0x1.ffffff84288ecp+14, 0x1.0000000debc76p-1,
      -0x1.d48d693fec428p-43, -0x1.0000177c4ffep+1, 0x1.0da3ea43ec4d8p-1, 0x1.00001a394d4b3p-1,
      0x1.ffffed164d431p-2, -0x1.ffca51feabeecp+0, -0x1.a4aba191392afp-1, -0x1.001c984c6ac6ep+59,
      -0x1.0000000412159p+59}},
    // uses 0.408
    {"turned", 0, 0, Rounding::kUpward,
     {-0x1.0170097cf02aep+52, -0x1.ffff7f449bfecp+1, 0x1.ffffff9d7236ep+44, 0x1.000000003bc97p+158,
      0x1.e837f4a0b1612p+1, 0x1.f5a1a58d1119fp-2, 0x1.ffffffec80873p-1, -0x1.b56c15fd03e4fp-1,
      -0x1.ffffd9d55394ep+1, -0x1.ffffffff90f71p+1, 0x1.0a5d1a1adb71bp+33, 0x1.0003bb8715fc9p+33,
      -0x1.064f93b14b431p+33}},
    // uses 0.625
    {"tensor", 1, 1, Rounding::kUpward,
     {0x1.fffffffffffffp-2, 0x1.fffffffffffffp-2, 0x1.ffffffffffffep-2, 0x1.0000000000001p-1}},
    // uses 0.525
    {"tensor", 3, 3, Rounding::kUpward,
     {0x1.000000000000cp-1, 0x1.000000000001p-1, 0x1.0000000000007p-1, 0x1.0000000000018p-1,
      0x1.0000000000011p-1, 0x1.ffffffffffffdp-2, 0x1.fffffffffffffp-2, 0x1.ffffffffffffdp-2,
      0x1.0000000000016p-1, 0x1.000000000001ap-1, 0x1.0000000000009p-1, 0x1.0000000000016p-1,
      0x1.0000000000003p-1, 0x1.0000000000011p-1, 0x1.0000000000012p-1, 0x1.0000000000006p-1}},
    // uses 0.750
    {"triangle", 1, 0, Rounding::kUpward,
     {0x1p-1, 0x1.0000000000001p-1, 0x1.fffffffffffffp-2}},
    // uses 0.583
    {"triangle", 3, 0, Rounding::kUpward,
     {0x1p-1, 0x1.ffffffffffffdp-2, 0x1.0000000000002p-1, 0x1.0000000000003p-1,
      0x1.fffffffffffffp-2, 0x1p-1, 0x1.ffffffffffffdp-2, 0x1.ffffffffffffcp-2,
      0x1p-1, 0x1.ffffffffffffdp-2}},
};
// clang-format on

}  // namespace veritope::piece_bounds
