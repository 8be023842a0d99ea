# Build options and the flags that every decision relies on.
option(VERITOPE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(VERITOPE_FUZZ "Build the fuzz targets (clang: libFuzzer; otherwise the replay mains)" OFF)
option(VERITOPE_BENCH "Build the benchmarks and the soak experiments (needs CGAL as the peer)" OFF)
option(VERITOPE_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})
set(VERITOPE_SANITIZE "" CACHE STRING "Comma-separated list for -fsanitize=")
option(VERITOPE_COVERAGE "Instrument for line and branch coverage (gcov)" OFF)

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
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VERITOPE_CCACHE}")
endif()

find_package(Threads REQUIRED)

add_library(veritope_flags INTERFACE)
# -ffp-contract=off: a fused product changes the rounding errors that the filters' bounds count.
target_compile_options(veritope_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic
                       -Wno-unused-parameter $<$<BOOL:${VERITOPE_WERROR}>:-Werror>)
if(VERITOPE_SANITIZE)
  target_compile_options(veritope_flags INTERFACE -fsanitize=${VERITOPE_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(veritope_flags INTERFACE -fsanitize=${VERITOPE_SANITIZE})
endif()
if(VERITOPE_COVERAGE)
  target_compile_options(veritope_flags INTERFACE --coverage -O1)
  target_link_options(veritope_flags INTERFACE --coverage)
endif()
