# The oracles: Boost.Interval and MPFI, in a file of their own.
find_path(VERITOPE_BOOST_INTERVAL boost/numeric/interval.hpp)
find_library(VERITOPE_MPFI mpfi)
if(VERITOPE_BOOST_INTERVAL AND VERITOPE_MPFI)
  veritope_test_binary(interval_oracle full "${PROJECT_SOURCE_DIR}/tests/interval/oracle/interval_differential.cc")
  target_compile_options(interval_oracle PRIVATE $<$<CXX_COMPILER_ID:GNU>:-frounding-math>)
  target_link_libraries(interval_oracle PRIVATE ${VERITOPE_MPFI} mpfr gmp)
else()
  message(STATUS "tests: no Boost.Interval or no MPFI, interval_oracle is left out")
endif()
if(NOT VERITOPE_SANITIZE AND NOT VERITOPE_COVERAGE)
  # An instrumented library would need the same flags in the program.
  add_test(NAME interval_hostile_flags COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/interval/hostile_flags_test.py"
           "${PROJECT_BINARY_DIR}" "${PROJECT_SOURCE_DIR}")
  set_tests_properties(interval_hostile_flags PROPERTIES LABELS full TIMEOUT 600)
endif()
