# Must-not-compile, for all layers up to predicates.
add_test(NAME compile_fail COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/compile_fail/compile_fail_test.py"
         "${CMAKE_CXX_COMPILER}" "${PROJECT_SOURCE_DIR}")
set_tests_properties(compile_fail PROPERTIES LABELS full TIMEOUT 600)
