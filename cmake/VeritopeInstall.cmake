# What an installation contains: the layers as static libraries with their headers, the programs, the checker in Python,
# the documents, a CMake package (veritope::<layer>, veritope::veritope = all of them) and veritope.pc.
# tests/install/ uses all of it.
include(CMakePackageConfigHelpers)
include(VeritopeHeaders)

# veritope_programs: every executable of cli/ and verify/checker/, without the tests.
set(veritope_executables "")
foreach(folder IN ITEMS cli verify/checker)
  get_property(targets DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      list(APPEND veritope_executables ${target})
    endif()
  endforeach()
endforeach()
add_custom_target(veritope_programs DEPENDS ${veritope_executables})

# Layers, lowest first. Example models, and layers that only the command line uses, are not
# installed.
set(veritope_layers "")
set(veritope_pc_libs "")
# Headers that include other libraries belong to a target of their own, veritope::interop, which veritope::veritope does
# not contain.
set(veritope_header_folders interop)
get_property(layers GLOBAL PROPERTY VERITOPE_LAYERS)
foreach(layer IN LISTS layers)
  get_target_property(folder ${layer} VERITOPE_FOLDER)
  if(folder MATCHES "^(cli|hard_models|models|named_predicates|render|report)$")
    continue()
  endif()
  list(APPEND veritope_layers ${layer})
  list(APPEND veritope_header_folders "${folder}")
  string(PREPEND veritope_pc_libs "-l${layer} ")
endforeach()

# Headers. Their includes are rewritten when they are installed, so that no edit of a header asks for a new
# configuration.
set(veritope_table "${PROJECT_SOURCE_DIR}/cmake/public_headers.txt")
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${veritope_table}")
veritope_read_public_headers("${veritope_table}" veritope_public_headers)
foreach(header IN LISTS veritope_public_headers)
  if(NOT EXISTS "${PROJECT_SOURCE_DIR}/${header}")
    message(FATAL_ERROR "cmake/public_headers.txt names ${header}, which does not exist")
  endif()
endforeach()
configure_file(cmake/version.h.in "${PROJECT_BINARY_DIR}/version.h" @ONLY)
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY "\${CMAKE_INSTALL_PREFIX}"
           OUTPUT_VARIABLE veritope_include_dir)
install(CODE "
  set(VERITOPE_ROOT [==[${PROJECT_SOURCE_DIR}]==])
  set(VERITOPE_TABLE [==[${veritope_table}]==])
  set(VERITOPE_FOLDERS ${veritope_header_folders})
  set(VERITOPE_VERSION_FILE [==[${PROJECT_BINARY_DIR}/version.h]==])
  set(VERITOPE_STAGE [==[${PROJECT_BINARY_DIR}/installed_headers]==])
  set(VERITOPE_DESTINATION \"${veritope_include_dir}/veritope\")")
install(SCRIPT cmake/InstallHeaders.cmake)

add_library(veritope_all INTERFACE)
add_library(veritope::veritope ALIAS veritope_all)
set_target_properties(veritope_all PROPERTIES EXPORT_NAME veritope)
target_link_libraries(veritope_all INTERFACE ${veritope_layers})

install(TARGETS veritope_all veritope_interop ${veritope_layers} EXPORT veritopeTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(TARGETS ${veritope_executables} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(PROGRAMS "${PROJECT_SOURCE_DIR}/verify/checker/veritope_check.py"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/veritope")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/verify/checker/veritope_checker"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/veritope"
        FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)

set(veritope_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/veritope")
install(EXPORT veritopeTargets NAMESPACE veritope:: DESTINATION "${veritope_cmake_dir}")
configure_package_config_file(cmake/veritopeConfig.cmake.in "${PROJECT_BINARY_DIR}/veritopeConfig.cmake"
                              INSTALL_DESTINATION "${veritope_cmake_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/veritopeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/veritopeConfig.cmake" "${PROJECT_BINARY_DIR}/veritopeConfigVersion.cmake"
        DESTINATION "${veritope_cmake_dir}")

# Paths in the .pc file are relative to it, so that an installed tree may be moved.
set(veritope_pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH veritope_pc_prefix "/p/${veritope_pc_dir}" "/p")
cmake_path(CONVERT "${veritope_pc_prefix}" TO_CMAKE_PATH_LIST veritope_pc_prefix NORMALIZE)
set(veritope_pc_definitions "")
if(VERITOPE_AUDIT)
  set(veritope_pc_definitions " -DVT_AUDIT")
endif()
configure_file(cmake/veritope.pc.in "${PROJECT_BINARY_DIR}/veritope.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/veritope.pc" DESTINATION "${veritope_pc_dir}")

# The documents for users. Pages name each other by their paths in the source tree, so those are kept.
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS cmake/installed_docs.txt)
file(STRINGS "${PROJECT_SOURCE_DIR}/cmake/installed_docs.txt" veritope_documents REGEX "^[^#]")
foreach(document IN LISTS veritope_documents)
  cmake_path(GET document PARENT_PATH folder)
  set(destination "${CMAKE_INSTALL_DOCDIR}/${folder}")
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${document}")
    install(DIRECTORY "${document}" DESTINATION "${destination}")
  elseif(EXISTS "${PROJECT_SOURCE_DIR}/${document}")
    install(FILES "${document}" DESTINATION "${destination}")
  else()
    message(FATAL_ERROR "cmake/installed_docs.txt names ${document}, which does not exist")
  endif()
endforeach()
# The models that the documents name. The programs of examples/ stay in the tree: their shapes are not installed.
file(GLOB veritope_example_models CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/*.*")
list(FILTER veritope_example_models EXCLUDE REGEX "/CMakeLists\\.txt$")
install(FILES ${veritope_example_models} DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples")
install(DIRECTORY examples/esc_figures DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples"
        FILES_MATCHING PATTERN "*.obj" PATTERN "*.off")
