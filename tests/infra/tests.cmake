# Tests of the tree itself: arrows, names, claims, licences, the front door, examples, README, checkers on their own, installation.
function(veritope_infra_test name label script)
  add_test(NAME infra_${name} COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/${script}" ${ARGN})
  set_tests_properties(infra_${name} PROPERTIES LABELS "${label};infra" TIMEOUT 600 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endfunction()

veritope_infra_test(layering quick layering_test.py)
veritope_infra_test(doc_links quick doc_links_test.py)
veritope_infra_test(claims quick claims_test.py)
veritope_infra_test(licence quick licence_test.py)
veritope_infra_test(examples quick examples_test.py)
veritope_infra_test(dev quick dev_test.py)
veritope_infra_test(readme quick readme_test.py "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
veritope_infra_test(checker_alone full checker_alone_test.py)
if(NOT VERITOPE_SANITIZE AND NOT VERITOPE_COVERAGE)
  # An instrumented library would need the same flags in the consumer.
  veritope_infra_test(install full install/install_test.py "${PROJECT_BINARY_DIR}" "${CMAKE_COMMAND}" "${CMAKE_CXX_COMPILER}")
endif()
