# The C++ checker against certificates of the reference prover; the real models are skipped with one message where there are none.
function(veritope_checker_test part label)
  add_test(NAME checker_cpp_${part}
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/checker_test.py" ${ARGN})
  veritope_tier(${label} checker_cpp_${part})
  set_tests_properties(checker_cpp_${part} PROPERTIES ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_SANITIZE=${VERITOPE_SANITIZE};VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endfunction()

veritope_checker_test(mesh standard Accepts Statements Valid Invalid Refuses)
veritope_checker_test(real_models standard RealModels)

add_test(NAME checker_input_kinds COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/input_kinds_test.py")
set_tests_properties(checker_input_kinds PROPERTIES LABELS quick TIMEOUT 600 ENVIRONMENT
                     "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")

# Certificates about spline models: the tests of the Python checker, with both checkers as judges.
foreach(kind IN ITEMS star_box star_box_turned patch_invalid collar)
  add_test(NAME checker_cpp_${kind} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/${kind}_test.py")
  veritope_tier(full checker_cpp_${kind})
  set_tests_properties(checker_cpp_${kind} PROPERTIES ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endforeach()
