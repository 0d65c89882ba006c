# Checks that installed binaries have no instruction whose result depends on the
# manufacturer of the processor (approximate roots and quotients), and no fused
# multiply-add, which some processors lack.
# FROM: build tree; OBJDUMP: the disassembler.
cmake_minimum_required(VERSION 3.25)

# Sets <result> to those instructions in a program or library.
function(find_inexact file result)
  execute_process(COMMAND "${OBJDUMP}" --disassemble --no-show-raw-insn --demangle "${file}"
                  OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
  set(name "v?(rsqrt|rcp)(14|28)?[ps][sdh]|vfn?m(add|sub)[a-z0-9]+")
  string(REGEX MATCHALL "\t(${name}) [^\n]*" found "${code}")
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

file(GLOB files "${FROM}/modules/*/lib*.so" "${FROM}/bin/pcl_*" "${FROM}/python/acmap/*.so")
list(LENGTH files count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} programs and libraries in ${FROM}")
endif()
foreach(file IN LISTS files)
  find_inexact("${file}" found)
  if(found)
    list(JOIN found "\n " list)
    message(SEND_ERROR "${file} has instructions that are not exact:\n ${list}")
  endif()
endforeach()
