# The C++ checker's parts linked in, so that thousands of certificates are checked in one process, and its programs for the rest.
foreach(part IN ITEMS quick full)
  if(TARGET certify_${part})
    target_sources(certify_${part} PRIVATE "$<FILTER:$<TARGET_OBJECTS:veritope-check>,EXCLUDE,/main\\.cc>")
    add_dependencies(certify_${part} veritope-check)
  endif()
endforeach()
