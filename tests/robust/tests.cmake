# Must-not-compile, for all layers up to predicates.
add_test(NAME compile_fail COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/compile_fail/compile_fail_test.py"
         "${CMAKE_CXX_COMPILER}" "${PROJECT_SOURCE_DIR}")
veritope_tier(full compile_fail)
# Cascades as audit mode has them, whatever this build has: a binary of its own, no other may see them.
veritope_test_binary(robust_audit quick "${PROJECT_SOURCE_DIR}/tests/robust/audit/audited_cascade.cc")
target_compile_definitions(robust_audit PRIVATE VT_AUDIT)
