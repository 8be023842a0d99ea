# Tests of the command line: each runs the programs. veritope_cli_test(<name> <label>): tests/cli/<name>_test.py
function(veritope_cli_test name label)
  add_test(NAME cli_${name} COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/cli/${name}_test.py")
  veritope_tier(${label} cli_${name})
  set_property(TEST cli_${name} APPEND PROPERTY LABELS cli)
  set_tests_properties(cli_${name} PROPERTIES ENVIRONMENT
    "PYTHONDONTWRITEBYTECODE=1;VERITOPE_BIN=${CMAKE_RUNTIME_OUTPUT_DIRECTORY};VERITOPE_SANITIZE=${VERITOPE_SANITIZE};VERITOPE_AUDIT=${VERITOPE_AUDIT}")
endfunction()

veritope_cli_test(models quick)
veritope_cli_test(command_line quick)
veritope_cli_test(json quick)
veritope_cli_test(certificates quick)
veritope_cli_test(convert quick)
veritope_cli_test(picture quick)
veritope_cli_test(splines quick)
veritope_cli_test(interruption quick)
veritope_cli_test(project quick)
veritope_cli_test(intersect quick)
veritope_cli_test(certify_patches standard)
veritope_cli_test(certify_itd quick)
veritope_cli_test(cover quick)
veritope_cli_test(predicate quick)
veritope_cli_test(selftest standard)
veritope_cli_test(corpus quick)
veritope_cli_test(manifest full)
# All of the corpus, and its checksum.
add_test(NAME cli_corpus_full COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/cli/corpus_test.py")
veritope_tier(full cli_corpus_full)
set_property(TEST cli_corpus_full APPEND PROPERTY LABELS cli)
set_tests_properties(cli_corpus_full PROPERTIES ENVIRONMENT
  "PYTHONDONTWRITEBYTECODE=1;CORPUS_CASES=0;VERITOPE_BIN=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
# The headers of predicates/ in programs of others.
veritope_hostile_flags_test(cli_hostile_flags tests/cli/hostile_predicates_main.cc named_predicates/hard_cases.cc named_predicates/implicit_names.cc named_predicates/named_predicate.cc)
