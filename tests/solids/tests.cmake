# Prints the rows of tests/solids/piece_bound_cases.h.
add_executable(piece_bound_search EXCLUDE_FROM_ALL "${CMAKE_CURRENT_LIST_DIR}/piece_bound_search_main.cc")
target_link_libraries(piece_bound_search PRIVATE veritope_test_flags veritope_test_support veritope::pieces)
set_target_properties(piece_bound_search PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
