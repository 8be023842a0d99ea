# The Python checker's unit tests.
add_test(NAME checker_py COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker_py/veritope_check_test.py")
set_tests_properties(checker_py PROPERTIES LABELS quick TIMEOUT 300 ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
