# Lying provers against both checkers, with fixed seeds; ./dev soak attacks, reading, patch_attacks,
# vmodel_attacks, vmodel_invalid_attacks, dms_attacks, dms_pairs_attacks, dms_invalid_attacks, micro_attacks and micro_inside_attacks run
# more.
set(label_of_mutation standard)
set(label_of_patch_mutation full)
set(label_of_vmodel_mutation standard)
set(label_of_vmodel_invalid_mutation standard)
set(label_of_micro_mutation standard)
set(label_of_dms_mutation standard)
set(label_of_dms_pairs_mutation standard)
set(label_of_dms_invalid_mutation standard)
foreach(name IN ITEMS mutation patch_mutation vmodel_mutation vmodel_invalid_mutation micro_mutation dms_mutation
        dms_pairs_mutation dms_invalid_mutation)
  add_test(NAME ${name} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/mutation/${name}_test.py")
  veritope_tier(${label_of_${name}} ${name})
  set_tests_properties(${name} PROPERTIES ENVIRONMENT
                       "PYTHONDONTWRITEBYTECODE=1;VERITOPE=$<TARGET_FILE:veritope>;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")
endforeach()

# What needs no compiler: every layer has places to mutate, and kernel_equivalent.txt names only such places.
add_test(NAME kernel_mutants_places COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/mutation/kernel_mutants_test.py")
veritope_tier(quick kernel_mutants_places)
set_tests_properties(kernel_mutants_places PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
