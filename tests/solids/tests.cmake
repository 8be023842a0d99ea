# Prints the rows of tests/solids/piece_bound_cases.h.
add_executable(piece_bound_search EXCLUDE_FROM_ALL "${CMAKE_CURRENT_LIST_DIR}/piece_bound_search_main.cc")
target_link_libraries(piece_bound_search PRIVATE veritope_test_flags veritope_test_support veritope::pieces)
set_target_properties(piece_bound_search PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")

# CGAL's Delaunay tetrahedralization as an oracle, in a binary of its own, as predicates_cgal.
if(VERITOPE_CGAL_INCLUDE)
  veritope_test_binary(solids_cgal standard "${PROJECT_SOURCE_DIR}/tests/solids/cgal/delaunay_cgal.cc")
  target_compile_options(solids_cgal PRIVATE $<$<CXX_COMPILER_ID:GNU>:-frounding-math> -w)
  target_link_libraries(solids_cgal PRIVATE gmp mpfr)
endif()
