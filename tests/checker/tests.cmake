# The C++ checker against certificates of the reference prover; the real models are skipped with one message where there are none.
function(veritope_checker_test part)
  add_test(NAME checker_cpp_${part}
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/checker_test.py" ${ARGN})
  set_tests_properties(checker_cpp_${part} PROPERTIES LABELS ${part} TIMEOUT 600 ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_SANITIZE=${VERITOPE_SANITIZE};VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endfunction()

veritope_checker_test(quick Accepts Statements Valid Invalid Refuses)
veritope_checker_test(full RealModels)

# Certificates about spline models: the tests of the Python checker, with both checkers as judges.
foreach(kind IN ITEMS star_box star_box_turned patch_invalid collar)
  add_test(NAME checker_cpp_${kind} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/${kind}_test.py")
  set_tests_properties(checker_cpp_${kind} PROPERTIES LABELS full TIMEOUT 900 ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endforeach()
