# A script that runs at every installation: writes the headers as users see them into a folder of the build tree, then
# installs that folder. The rules: cmake/VeritopeHeaders.cmake. Needed variables:
#   VERITOPE_ROOT          the tree
#   VERITOPE_TABLE         its cmake/public_headers.txt
#   VERITOPE_FOLDERS       the folders whose headers are installed
#   VERITOPE_VERSION_FILE  version.h, which configure_file has made
#   VERITOPE_STAGE         the folder to write; what else is in it is removed
#   VERITOPE_DESTINATION   where to install; without it the script only writes
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/VeritopeHeaders.cmake")

function(veritope_write_headers)
  veritope_read_public_headers("${VERITOPE_TABLE}" public)
  veritope_list_headers("${VERITOPE_ROOT}" headers ${VERITOPE_FOLDERS})
  foreach(source IN LISTS public)
    if(NOT source IN_LIST headers AND NOT source STREQUAL "cmake/version.h.in")
      message(FATAL_ERROR "${VERITOPE_TABLE} names ${source}, which is not a header that is installed")
    endif()
  endforeach()

  set(names version.h)
  file(COPY_FILE "${VERITOPE_VERSION_FILE}" "${VERITOPE_STAGE}/version.h" ONLY_IF_DIFFERENT)
  foreach(source IN LISTS headers)
    veritope_installed_name("${source}" name)
    if(name IN_LIST names)
      message(FATAL_ERROR "two headers would be installed as veritope/${name}; one is ${source}")
    endif()
    list(APPEND names "${name}")
    veritope_installed_text("${VERITOPE_ROOT}" "${headers}" "${source}" text)
    set(old "")
    if(EXISTS "${VERITOPE_STAGE}/${name}")
      file(READ "${VERITOPE_STAGE}/${name}" old)
    endif()
    if(NOT old STREQUAL text)  # otherwise users' programs would be compiled again
      file(WRITE "${VERITOPE_STAGE}/${name}" "${text}")
    endif()
  endforeach()

  file(GLOB_RECURSE there RELATIVE "${VERITOPE_STAGE}" "${VERITOPE_STAGE}/*")
  foreach(name IN LISTS there)
    if(NOT name IN_LIST names)
      file(REMOVE "${VERITOPE_STAGE}/${name}")
    endif()
  endforeach()
endfunction()

file(MAKE_DIRECTORY "${VERITOPE_STAGE}")
veritope_write_headers()
if(VERITOPE_DESTINATION)
  file(INSTALL DESTINATION "${VERITOPE_DESTINATION}" TYPE DIRECTORY FILES "${VERITOPE_STAGE}/"
       FILES_MATCHING PATTERN "*.h")
endif()
