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
veritope_judges_test(points points standard)
veritope_judges_test(points_cpp points_cpp standard)
veritope_judges_test(patch_points patch_points standard)
veritope_judges_test(expression_points expression_points standard)
veritope_judges_test(volume_folded volume_folded standard)
veritope_judges_test(vmodel vmodel standard)
veritope_judges_test(vmodel_invalid_cpp vmodel_invalid_cpp standard)
veritope_judges_test(vmodel_invalid vmodel_invalid standard)
veritope_judges_test(micro_cpp micro_cpp standard)
foreach(part IN ITEMS inside sweeps patches)
  veritope_judges_test(micro_${part}_cpp micro_${part}_cpp standard)
endforeach()
veritope_judges_test(dms_solid dms_solid standard)
veritope_judges_test(dms_pairs dms_pairs standard)
veritope_judges_test(dms_invalid dms_invalid standard)
veritope_judges_test(dms_refuted dms_refuted standard)
set_property(TEST checker_cpp_micro_cpp checker_cpp_micro_inside_cpp checker_cpp_micro_sweeps_cpp checker_cpp_micro_patches_cpp
             checker_cpp_dms_solid checker_cpp_dms_pairs checker_cpp_dms_refuted APPEND PROPERTY ENVIRONMENT "VERITOPE=$<TARGET_FILE:veritope>")
veritope_judges_test(real_models mesh_real_models standard)
foreach(kind IN ITEMS star_box star_box_turned star_box_2 star_box_2_cpp patch_invalid patch_invalid_2 collar collar_2)
  veritope_judges_test(${kind} ${kind} full)
endforeach()

add_test(NAME checker_input_kinds COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/checker/input_kinds_test.py")
set_tests_properties(checker_input_kinds PROPERTIES LABELS quick TIMEOUT 600 ENVIRONMENT
                     "PYTHONDONTWRITEBYTECODE=1;VERITOPE_CHECK=$<TARGET_FILE:veritope-check>")

# The readers of spline models alone, so that tests can compare what they find, not only what is accepted.
file(GLOB readers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/verify/checker/patches/*_reader.cc"
     "${PROJECT_SOURCE_DIR}/verify/checker/patches/volume_*.cc")
list(FILTER readers EXCLUDE REGEX "/volume_point\\.cc$")  # of certificates, not of models
list(APPEND readers "${PROJECT_SOURCE_DIR}/verify/checker/patches/star_model.cc"
     "${PROJECT_SOURCE_DIR}/verify/checker/patches/mfem_topology.cc")
add_executable(print_model "${CMAKE_CURRENT_SOURCE_DIR}/checker/print_model.cc" ${readers})
target_include_directories(print_model PRIVATE "${PROJECT_SOURCE_DIR}")
set_target_properties(print_model PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")

foreach(part IN ITEMS g2 mfem faces)
  veritope_judges_test(model_${part} model_${part} standard)
  veritope_judges_test(${part}_cpp ${part}_cpp standard)
  set_property(TEST checker_cpp_${part}_cpp APPEND PROPERTY ENVIRONMENT "VERITOPE_PRINT_MODEL=$<TARGET_FILE:print_model>")
endforeach()
