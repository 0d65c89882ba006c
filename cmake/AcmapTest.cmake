# acmap_add_test (<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...])
#
# One GoogleTest program, one ctest entry; a program that skips every test it has counts as
# skipped. Target tests_<label> builds all programs of a label.
function(acmap_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS")
  acmap_add_program(${name}_test SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES}
                    acmap_test_support GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name}_test)
  set_tests_properties(
    ${name} PROPERTIES LABELS "${arg_LABELS}" ENVIRONMENT "ACMAP_TEST_DATA=${ACMAP_TEST_DATA}"
                       SKIP_REGULAR_EXPRESSION "PASSED  . 0 tests")
  foreach(label IN LISTS arg_LABELS)
    acmap_join(tests_${label} ${name}_test)
  endforeach()
endfunction()

# acmap_add_fuzzer (<name> SOURCES <file>... LIBRARIES <target>... [CORPUS <folder>])
#
# A libFuzzer program; ctest runs it for ACMAP_FUZZ_SECONDS from the corpus on. What it
# finds on the way stays in the build folder. Target fuzzers builds them all.
function(acmap_add_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS" "SOURCES;LIBRARIES")
  acmap_add_program(${name} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES})
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  if(arg_CORPUS)
    cmake_path(ABSOLUTE_PATH arg_CORPUS)
  endif()
  set(found "${CMAKE_CURRENT_BINARY_DIR}/${name}.corpus")
  file(MAKE_DIRECTORY "${found}")
  add_test(NAME ${name} COMMAND ${name} -max_total_time=${ACMAP_FUZZ_SECONDS} -timeout=10
                                -rss_limit_mb=2048 -malloc_limit_mb=256 "${found}" ${arg_CORPUS})
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
