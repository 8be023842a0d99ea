# CGAL's kernel as an oracle, in a binary of its own. CGAL's interval filters need -frounding-math; its headers are not ours to warn about.
find_path(VERITOPE_CGAL_INCLUDE CGAL/version.h)
if(VERITOPE_CGAL_INCLUDE)
  veritope_test_binary(predicates_cgal standard "${PROJECT_SOURCE_DIR}/tests/predicates/cgal/cgal_differential.cc")
  target_compile_options(predicates_cgal PRIVATE $<$<CXX_COMPILER_ID:GNU>:-frounding-math> -w)
  target_link_libraries(predicates_cgal PRIVATE gmp mpfr)
else()
  message(STATUS "tests: no CGAL, predicates_cgal is left out")
endif()
# The predicates that tools/generate_predicates.py made, one file each, and what they share.
file(GLOB generated CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/predicates/generated/*_test.cc")
veritope_test_binary(predicates_generated quick ${generated})
function(veritope_generated_test name label script)
  add_test(NAME predicates_${name} COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/predicates/generated/${script}" ${ARGN})
  veritope_tier(${label} predicates_${name})
  set_tests_properties(predicates_${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endfunction()
veritope_generated_test(gappa quick gappa_test.py)
veritope_generated_test(gappa_boxes full gappa_test.py --boxes)
veritope_generated_test(coq_terms quick coq_terms_test.py)
if(VERITOPE_SANITIZE OR VERITOPE_COVERAGE OR VERITOPE_AUDIT)
  # An instrumented library would need the same flags in what the test compiles.
  veritope_generated_test(generator standard generator_test.py)
else()
  veritope_generated_test(generator standard generator_test.py "${CMAKE_CXX_COMPILER}"
                          $<TARGET_FILE:veritope_predicates>
                          $<TARGET_FILE:veritope_interval> $<TARGET_FILE:veritope_robust> $<TARGET_FILE:veritope_base>)
endif()
