# The names and the text of installed headers. Users include <veritope/...> and nothing else. In the tree, headers
# include each other as "interval/interval.h"; an installed copy says <veritope/interval/interval.h>, or
# <veritope/internal/ROOM/x.h> for a header that is not public, so that no folder of a user's own can come in between.
# cmake/VeritopeInstall.cmake uses this file when the tree is configured, cmake/InstallHeaders.cmake when it is
# installed.

# veritope_read_public_headers(TABLE OUT): reads a table such as cmake/public_headers.txt. OUT: its sources, in order.
# Sets VERITOPE_INSTALLED_AS_<source> for each of them.
macro(veritope_read_public_headers table out)
  set(${out} "")
  file(READ "${table}" veritope_rows)
  # Only paths and the arrow are taken from a row: its sentence may contain what has a meaning in a list.
  string(REGEX MATCHALL "\n[a-z][A-Za-z0-9_./+ >-]*" veritope_rows "\n${veritope_rows}")
  foreach(veritope_row IN LISTS veritope_rows)
    string(STRIP "${veritope_row}" veritope_row)
    if(veritope_row MATCHES "^([^ ]+) -> ([^ ]+)$")
      set(veritope_source "${CMAKE_MATCH_1}")
      set(veritope_name "${CMAKE_MATCH_2}")
    elseif(veritope_row MATCHES "^[^ ]+$")
      set(veritope_source "${veritope_row}")
      set(veritope_name "${veritope_row}")
    else()
      message(FATAL_ERROR "${table}: \"${veritope_row}\" is neither SOURCE nor SOURCE -> NAME")
    endif()
    list(APPEND ${out} "${veritope_source}")
    set("VERITOPE_INSTALLED_AS_${veritope_source}" "${veritope_name}")
  endforeach()
endmacro()

# veritope_installed_name(SOURCE OUT): the path below include/veritope of a header of the tree.
function(veritope_installed_name source out)
  if(DEFINED "VERITOPE_INSTALLED_AS_${source}")
    set(${out} "${VERITOPE_INSTALLED_AS_${source}}" PARENT_SCOPE)
  else()
    set(${out} "internal/${source}" PARENT_SCOPE)
  endif()
endfunction()

# veritope_list_headers(ROOT OUT FOLDER...): the headers of these folders that are installed, relative to ROOT.
function(veritope_list_headers root out)
  set(patterns ${ARGN})
  list(TRANSFORM patterns PREPEND "${root}/")
  set(generated ${patterns})
  list(TRANSFORM patterns APPEND "/*.h")
  list(TRANSFORM generated APPEND "/generated/*.h")
  file(GLOB headers RELATIVE "${root}" ${patterns} ${generated})
  list(FILTER headers EXCLUDE REGEX "_internal\\.h$")
  set(${out} "${headers}" PARENT_SCOPE)
endfunction()

# veritope_installed_text(ROOT HEADERS SOURCE OUT): the text of SOURCE as it is installed. Two things change: the
# includes of HEADERS are rewritten, and a line after "#pragma once" includes version.h, which reports an older C++ than
# C++20 before anything else. All other bytes stay: the text is never part of a list, where brackets and semicolons have
# a meaning.
function(veritope_installed_text root headers source out)
  file(READ "${root}/${source}" text)
  file(SIZE "${root}/${source}" size)
  string(LENGTH "${text}" length)
  if(NOT length EQUAL size)
    message(FATAL_ERROR "${source} has bytes that CMake does not read, such as carriage returns")
  endif()
  string(PREPEND text "\n")  # so that every line begins after a line feed
  string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*\"[A-Za-z0-9_./+-]+\"" includes "${text}")
  list(REMOVE_DUPLICATES includes)
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^.*\"([^\"]+)\"$" "\\1" name "${include}")
    if(NOT name IN_LIST headers)
      message(FATAL_ERROR "${source} includes \"${name}\", which is not an installed header")
    endif()
    veritope_installed_name("${name}" installed)
    string(REPLACE "\"${name}\"" "<veritope/${installed}>" replacement "${include}")
    string(REPLACE "${include}" "${replacement}" text "${text}")
  endforeach()
  if(text MATCHES "\n([ \t]*#[ \t]*include[ \t]*\"[^\n]*)")
    message(FATAL_ERROR "${source}: this include is not understood: ${CMAKE_MATCH_1}")
  endif()
  set(once "\n#pragma once\n")
  string(FIND "${text}" "${once}" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "${source} has no line #pragma once")
  endif()
  string(LENGTH "${once}" length)
  math(EXPR end "${begin} + ${length}")
  string(SUBSTRING "${text}" ${end} -1 after)
  math(EXPR length "${end} - 1")
  string(SUBSTRING "${text}" 1 ${length} before)
  set(${out} "${before}#include <veritope/version.h>\n${after}" PARENT_SCOPE)
endfunction()
