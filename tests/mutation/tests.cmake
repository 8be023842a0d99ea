# Lying provers against both checkers, with fixed seeds; ./dev soak attacks, reading and patch_attacks run more.
foreach(name IN ITEMS mutation patch_mutation)
  add_test(NAME ${name} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/mutation/${name}_test.py")
  set_tests_properties(${name} PROPERTIES LABELS full TIMEOUT 600 ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endforeach()
