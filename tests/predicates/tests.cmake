# CGAL's kernel as an oracle, in a binary of its own. CGAL's interval filters need -frounding-math; its headers are not ours to warn about.
find_path(VERITOPE_CGAL_INCLUDE CGAL/version.h)
if(VERITOPE_CGAL_INCLUDE)
  veritope_test_binary(predicates_cgal full "${PROJECT_SOURCE_DIR}/tests/predicates/cgal/cgal_differential.cc")
  target_compile_options(predicates_cgal PRIVATE $<$<CXX_COMPILER_ID:GNU>:-frounding-math> -w)
  target_link_libraries(predicates_cgal PRIVATE gmp mpfr)
else()
  message(STATUS "tests: no CGAL, predicates_cgal is left out")
endif()
