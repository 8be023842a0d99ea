# Build options, and the flags on which every decision relies.
option(VERITOPE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(VERITOPE_FUZZ "Build the fuzz targets (clang: libFuzzer; otherwise the replay mains)" OFF)
option(VERITOPE_BENCH "Build the benchmarks and the soak experiments (needs CGAL as the peer)" OFF)
option(VERITOPE_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})
option(VERITOPE_SLOW_CHECKS "Turn on VT_SLOW_CHECK in builds that define NDEBUG" OFF)
option(VERITOPE_AUDIT "Ask all tiers of each cascade and stop at a contradiction (robust/cascade.h)" OFF)
option(VERITOPE_COVERAGE "Instrument for source-based branch coverage (clang), see ./dev coverage" OFF)
option(VERITOPE_UNITY "Compile the files of a layer in batches: a whole build takes less time, one edit more" ON)
set(VERITOPE_SANITIZE "" CACHE STRING "Comma-separated list for -fsanitize=")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_VISIBILITY_PRESET default)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

find_program(VERITOPE_CCACHE ccache)
if(VERITOPE_CCACHE AND PROJECT_IS_TOP_LEVEL)
  # ccache accepts objects that include a precompiled header only with these settings; no source asks for the time.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros "${VERITOPE_CCACHE}")
endif()

find_package(Threads REQUIRED)

# All targets are instrumented, the checker included.
if(VERITOPE_SANITIZE)
  add_compile_options(-fsanitize=${VERITOPE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VERITOPE_SANITIZE})
endif()
if(VERITOPE_FUZZ AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # libFuzzer sees only code compiled with this flag; -fsanitize=fuzzer on the targets adds its main.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(VERITOPE_COVERAGE)
  # Source-based: a branch in the report is a condition of the source. %m: one file for each program, merged after each
  # run.
  add_compile_options(-fprofile-instr-generate=${PROJECT_BINARY_DIR}/profiles/%m.profraw -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
endif()
if(VERITOPE_SLOW_CHECKS)
  add_compile_definitions(VERITOPE_SLOW_CHECKS)
endif()

add_library(veritope_flags INTERFACE)
# -ffp-contract=off: a fused product changes the rounding errors that the filters' bounds count.
target_compile_options(veritope_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic
                       -Wno-unused-parameter $<$<BOOL:${VERITOPE_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC looks for garbage whenever its heap has grown by 128 MiB or less, which takes 5 to 12 % of the time of a batch
  # and frees little. This parameter changes no code; a unit takes up to a quarter more memory, 1.2 GB at most.
  target_compile_options(veritope_flags INTERFACE --param=ggc-min-heapsize=1000000)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of GCC 12: sums of a literal and a std::string "overlap" or "overflow" (its bug 105651), a moved-from
  # Error is "uninitialized" once it is inlined into a variant. clang and the sanitizers look for these mistakes.
  target_compile_options(veritope_flags INTERFACE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
                         -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
