# The folders of docs/layers.txt: a file belongs to the longest of them that its path begins with.
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS docs/layers.txt)
file(STRINGS "${PROJECT_SOURCE_DIR}/docs/layers.txt" rows REGEX "^[a-z]")
list(TRANSFORM rows REPLACE " *\\|.*" "" OUTPUT_VARIABLE VERITOPE_ROOMS)

# The standard headers that most units of the layers include, compiled once: parsing them takes approximately a third of
# a unit's time. It contains no header of ours, so our edits do not recompile it. A precompiled header can hide a
# missing include in a .cc file: the presets debug, fuzz and coverage build without it.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/veritope_pch.cc" CONTENT "")
add_library(veritope_pch OBJECT "${PROJECT_BINARY_DIR}/veritope_pch.cc")
target_compile_features(veritope_pch PUBLIC cxx_std_20)
target_link_libraries(veritope_pch PRIVATE veritope_flags)
set(VERITOPE_PRECOMPILED <algorithm> <array> <bit> <cmath> <cstddef> <cstdint> <functional> <limits> <map> <memory>
                         <numeric> <optional> <span> <string> <string_view> <utility> <variant> <vector>)
target_precompile_headers(veritope_pch PRIVATE ${VERITOPE_PRECOMPILED})

# veritope_file_options(FLAGS FILE...): gives files of the current folder FLAGS besides those of the layer. A
# precompiled header is valid for one set of flags only, so these files do without it, and they are in no batch.
# FLAGS may be empty: a file that has flags with one compiler is single with all, and its object has one name.
function(veritope_file_options flags)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${flags}" SKIP_PRECOMPILE_HEADERS ON
                              SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# veritope_batches(TARGET): the compiler takes the files of TARGET sixteen at a time ("unity build"), so that it parses
# shared headers and instantiates shared templates once a batch. Files with flags of their own stay single. A name in an
# anonymous namespace must therefore be the only one of its kind in its folder.
function(veritope_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${VERITOPE_UNITY} UNITY_BUILD_BATCH_SIZE 16)
  if(VERITOPE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes a .cc file of a batch for a header, and warns of types of anonymous namespaces in its classes.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# veritope_layer(NAME FOLDER LINK...): one library a row of docs/layers.txt, from the .cc files that belong to its
# folder. LINK names the layers that the row allows, so that the linker knows the same arrows as the test. A layer whose
# units share a large header of others names it in VERITOPE_ALSO_PRECOMPILED.
function(veritope_layer name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*.cc")
  foreach(room IN LISTS VERITOPE_ROOMS)
    if(room MATCHES "^${folder}/")
      list(FILTER sources EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${room}/")
    endif()
  endforeach()
  add_library(veritope_${name} STATIC ${sources})
  add_library(veritope::${name} ALIAS veritope_${name})
  veritope_batches(veritope_${name})
  target_include_directories(veritope_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(veritope_${name} PUBLIC cxx_std_20)
  target_link_libraries(veritope_${name} PRIVATE $<BUILD_INTERFACE:veritope_flags>)
  if(VERITOPE_ALSO_PRECOMPILED)
    target_precompile_headers(veritope_${name} PRIVATE ${VERITOPE_PRECOMPILED} ${VERITOPE_ALSO_PRECOMPILED})
  else()
    target_precompile_headers(veritope_${name} REUSE_FROM veritope_pch)
  endif()
  foreach(lower IN LISTS ARGN)
    target_link_libraries(veritope_${name} PUBLIC ${lower})
  endforeach()
  # Users of our inline filters need arithmetic without contraction, too.
  target_compile_options(veritope_${name} INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
  set_target_properties(veritope_${name} PROPERTIES EXPORT_NAME ${name} VERITOPE_FOLDER "${folder}")
  set_property(GLOBAL APPEND PROPERTY VERITOPE_LAYERS veritope_${name})
endfunction()
