# Lying provers against both checkers, with fixed seeds; ./dev soak attacks and reading run more.
add_test(NAME mutation COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/mutation/mutation_test.py")
set_tests_properties(mutation PROPERTIES LABELS full TIMEOUT 600 ENVIRONMENT
                     "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
