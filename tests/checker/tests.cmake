# The C++ checker against certificates of the reference prover; the real models are skipped with one message where there are none.
foreach(part IN ITEMS quick full)
  if(part STREQUAL quick)
    set(classes Accepts Statements Valid Invalid Refuses)
  else()
    set(classes RealModels)
  endif()
  add_test(NAME checker_cpp_${part}
           COMMAND Python3::Interpreter "${CMAKE_CURRENT_LIST_DIR}/checker_test.py" ${classes})
  set_tests_properties(checker_cpp_${part} PROPERTIES LABELS ${part} TIMEOUT 600 ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endforeach()
