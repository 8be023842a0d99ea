# The tests of the Python checker, with both checkers as judges; the real models are skipped with one message where they are missing.
function(veritope_judges_test part script label)
  add_test(NAME checker_cpp_${part} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/${script}_test.py")
  veritope_tier(${label} checker_cpp_${part})
  set_tests_properties(checker_cpp_${part} PROPERTIES ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_SANITIZE=${VERITOPE_SANITIZE};VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endfunction()

veritope_judges_test(mesh mesh standard)
veritope_judges_test(mesh_reading mesh_reading standard)
veritope_judges_test(mesh_reversed mesh_reversed standard)
veritope_judges_test(mesh_reversed_cpp mesh_reversed_cpp standard)
veritope_judges_test(real_models mesh_real_models standard)
foreach(kind IN ITEMS star_box star_box_turned star_box_2 star_box_2_cpp patch_invalid patch_invalid_2 collar)
  veritope_judges_test(${kind} ${kind} full)
endforeach()

add_test(NAME checker_input_kinds COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/input_kinds_test.py")
set_tests_properties(checker_input_kinds PROPERTIES LABELS quick TIMEOUT 600 ENVIRONMENT
                     "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
