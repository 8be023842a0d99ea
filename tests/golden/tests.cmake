# Every compiler, optimization level and number of threads gives the same bytes: golden_test.py builds this program four more times.
add_executable(golden_hash "${CMAKE_CURRENT_LIST_DIR}/hash_main.cc")
target_link_libraries(golden_hash PRIVATE veritope_flags veritope_test_support veritope::certify veritope::render)
target_link_options(golden_hash PRIVATE "LINKER:-Map,${PROJECT_BINARY_DIR}/tests/golden_hash.map")
set_target_properties(golden_hash PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")
add_test(NAME golden_hashes_here COMMAND Python3::Interpreter "${CMAKE_CURRENT_LIST_DIR}/golden_test.py" --program "$<TARGET_FILE:golden_hash>")
veritope_tier(quick golden_hashes_here)
set_tests_properties(golden_hashes_here PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
if(NOT VERITOPE_SANITIZE AND NOT VERITOPE_COVERAGE)
  add_test(NAME golden_compilers COMMAND Python3::Interpreter "${CMAKE_CURRENT_LIST_DIR}/golden_test.py"
           --cmake "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}/golden" --map "${PROJECT_BINARY_DIR}/tests/golden_hash.map")
  veritope_tier(full golden_compilers)
  set_tests_properties(golden_compilers PROPERTIES PROCESSORS 2 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endif()
