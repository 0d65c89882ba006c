# Checks that the AVX2 variant of the surface kernel gives its instructions to functions of
# its own namespace only: others may be merged with those of other sources, which run on any
# processor.
# OBJECTS: folder of the module's object files; OBJDUMP: the disassembler.
cmake_minimum_required(VERSION 3.25)

set(object "${OBJECTS}/src/dewall_avx2.cpp.o")
if(NOT EXISTS "${object}")
  message("skipped: there is no ${object}")
  return()
endif()
execute_process(COMMAND "${OBJDUMP}" --disassemble --no-show-raw-insn "${object}"
                OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[0-9a-f]+ <[^\n]*>:\n|\tv[a-z0-9]+ " marks "${code}")
set(function "")
set(found "")
foreach(mark IN LISTS marks)
  if(mark MATCHES "<(.*)>")
    set(function "${CMAKE_MATCH_1}")
  elseif(NOT function MATCHES "dewall_avx2")
    list(APPEND found "${function}")
  endif()
endforeach()
list(REMOVE_DUPLICATES found)
if(found)
  list(JOIN found "\n " list)
  message(FATAL_ERROR "AVX2 in functions outside of dewall_avx2:\n ${list}")
endif()
