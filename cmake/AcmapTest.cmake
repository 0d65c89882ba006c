# acmap_add_test (<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...])
#
# One GoogleTest program, one ctest entry; a program that skips every test it has counts as
# skipped. Target tests_<label> builds all programs of a label. Kernels are reached by
# acmap_<module>_objects, and then nothing may bring acmap::<module> along: there would be
# two of them.
function(acmap_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS")
  acmap_add_program(${name}_test SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES}
                    acmap_test_support acmap_test_main)
  add_test(NAME ${name} COMMAND ${name}_test)
  set_tests_properties(
    ${name} PROPERTIES LABELS "${arg_LABELS}" ENVIRONMENT "ACMAP_TEST_DATA=${ACMAP_TEST_DATA}"
                       SKIP_RETURN_CODE 77)
  foreach(label IN LISTS arg_LABELS)
    acmap_join(tests_${label} ${name}_test)
  endforeach()
endfunction()

# acmap_add_fuzzer (<name> SOURCES <file>... LIBRARIES <target>... [CORPUS <folder>]
#                   [MAX_LENGTH <bytes>])
#
# A libFuzzer program, which sets out from corpus/<name> beside it, and from another folder
# if one is named; it takes words from dictionaries/<name>.dict where that is. ctest runs it
# over the corpora, and till ACMAP_FUZZ_SECONDS are over. What it finds on the way stays in
# the build folder. Target fuzzers builds them all; property ACMAP_FUZZERS lists them with
# their options, for test/fuzz/long_run.sh.
function(acmap_add_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS;MAX_LENGTH" "SOURCES;LIBRARIES")
  acmap_add_program(${name} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES})
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  set(found "${CMAKE_CURRENT_BINARY_DIR}/${name}.corpus")
  file(MAKE_DIRECTORY "${found}")
  # Seeds by entropy cost short runs more than they find.
  set(options -entropic=0 -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=256)
  if(arg_MAX_LENGTH)
    list(PREPEND options -max_len=${arg_MAX_LENGTH})
  endif()
  set(words "${CMAKE_CURRENT_SOURCE_DIR}/dictionaries/${name}.dict")
  if(EXISTS "${words}")
    list(APPEND options "-dict=${words}")
  endif()
  foreach(folder IN ITEMS "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}" ${arg_CORPUS})
    if(IS_DIRECTORY "${folder}")
      list(APPEND options "${folder}")
    endif()
  endforeach()
  # The same inputs each time: new ones are for the long run.
  add_test(NAME ${name} COMMAND ${name} -seed=1 -max_total_time=${ACMAP_FUZZ_SECONDS}
                                "${found}" ${options})
  list(JOIN options " " options)
  set_property(GLOBAL APPEND_STRING PROPERTY ACMAP_FUZZERS "${name} ${options}\n")
  set_tests_properties(${name} PROPERTIES LABELS fuzz)
  acmap_join(fuzzers ${name})
endfunction()

# acmap_add_usb_test (<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...])
#
# As acmap_add_test, for a program with a UsbTestbed, and for the programs that it starts.
function(acmap_add_usb_test name)
  acmap_add_test(${name} ${ARGN})
  target_link_libraries(${name}_test PRIVATE acmap_test_emulated_camera)
  acmap_sanitizer_runtime(libraries)
  list(APPEND libraries "${UMOCKDEV_PRELOAD_LIBRARY}")
  list(JOIN libraries ":" libraries)
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "LD_PRELOAD=${libraries}")
endfunction()

# acmap_sanitizer_runtime (<variable>): the runtime library of a sanitizer that insists on
# being the first one of a program, or nothing.
function(acmap_sanitizer_runtime variable)
  set(${variable} "" PARENT_SCOPE)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  # Clang links its runtime into the program.
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU OR NOT flags MATCHES "-fsanitize=(address|thread)")
    return()
  endif()
  string(SUBSTRING "${CMAKE_MATCH_1}" 0 1 letter)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=lib${letter}san.so
                  OUTPUT_VARIABLE library OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${variable} "${library}" PARENT_SCOPE)
endfunction()
