# The readers are compared with both checkers.
if(TARGET io_full AND TARGET veritope-check)
  add_dependencies(io_full veritope-check)
endif()
