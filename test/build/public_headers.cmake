# Compiles all installed headers in one source as a user may, whose own warnings are strict, and
# checks what the headers say to a source that they do not fit. PREFIX: of an installation;
# OUTPUT: a folder; PROCESSOR: of this machine; SYSTEM: folders of other libraries' headers.
cmake_minimum_required(VERSION 3.25)
file(GLOB include "${PREFIX}/include/acmap-*")
file(GLOB_RECURSE headers RELATIVE "${include}" "${include}/*.h" "${include}/*.hpp")
list(REMOVE_ITEM SYSTEM /usr/include) # GCC finds the C library there by itself only
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE lines)
list(JOIN lines "" source)
file(WRITE "${OUTPUT}/all_headers.cpp" "${source}")
file(WRITE "${OUTPUT}/one_header.cpp" "#include <pcl/core/plane_patch.h>\n")

set(flags -fsyntax-only -Wall -Wextra -Wpedantic -Werror "-I${include}")
foreach(folder IN LISTS SYSTEM)
  list(APPEND flags -isystem "${folder}")
endforeach()

# compile (<name of source> <option>...): sets result and output.
function(compile name)
  execute_process(COMMAND "${compiler}" ${flags} ${ARGN} "${OUTPUT}/${name}.cpp"
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

# refuse (<sentence> <option>...): the first error must be this sentence.
function(refuse sentence)
  compile(one_header ${ARGN})
  string(REGEX MATCH "error: [^\n]*" error "${output}")
  if(result EQUAL 0 OR NOT error MATCHES "${sentence}")
    message(SEND_ERROR "${compiler} ${ARGN} does not say first \"${sentence}\":\n${output}")
  endif()
endfunction()

# accept (<name of source> <option>...)
function(accept name)
  compile(${name} ${ARGN})
  if(NOT result EQUAL 0)
    message(SEND_ERROR "${compiler} ${ARGN}:\n${output}")
  endif()
endfunction()

foreach(name IN ITEMS g++ clang++)
  find_program(compiler NAMES "${name}" NO_CACHE)
  if(compiler)
    accept(all_headers -std=c++17)
    refuse("acmap needs C\\+\\+17" -std=c++14)
    set(aligned "Eigen aligns memory otherwise")
    refuse("${aligned}" -std=c++17 -DEIGEN_MAX_STATIC_ALIGN_BYTES=0)
    refuse("${aligned}" -std=c++17 -DEIGEN_MALLOC_ALREADY_ALIGNED=0)
    if(PROCESSOR MATCHES "x86_64|AMD64")
      set(as_built -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16)
      foreach(instructions IN ITEMS -mavx "-mavx512f;-mfma")
        refuse("${aligned}" -std=c++17 ${instructions})
        refuse("${aligned}" -std=c++17 ${instructions} ${as_built})
        accept(one_header -std=c++17 ${instructions} ${as_built} -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
      endforeach()
    endif()
  endif()
  unset(compiler)
endforeach()
