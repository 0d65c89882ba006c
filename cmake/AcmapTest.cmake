# acmap_add_test (<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...]
#                 [OPTIMIZED] [PRODUCT_CASES <filter>] [THREAD_CASES <filter>])
#
# One GoogleTest program, one ctest entry; a program that skips every test it has counts as
# skipped. Each test also has the label of its folder of test/. Target tests_<label> builds
# all programs of a label, tests_<label>_<folder> those of a folder. Which test runs where is
# told in test/README.md: those of tools, pictures and real data as users get them (label
# product), the others under AddressSanitizer (label sanitized), but for those of USB threads,
# which run under ThreadSanitizer (label threads), and those with label long not at all.
#
# PRODUCT_CASES are those of a sanitized program that compute much with kernels which its
# other cases run, too: they run as users get them, in test <name>_product. THREAD_CASES are
# those of a program with label threads that run under ThreadSanitizer in CI, in test
# <name>_threads. Both are filters of GoogleTest; a filter of PRODUCT_CASES that begins with
# a minus names the other cases. The long run has all cases in all presets: under
# ThreadSanitizer also those with label all_threads, whose libraries CI does not build for it.
#
# Kernels are reached by acmap_<module>_objects, and then nothing may bring acmap::<module>
# along: there would be two of them.
function(acmap_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIMIZED" "PRODUCT_CASES;THREAD_CASES"
                        "SOURCES;LIBRARIES;LABELS")
  acmap_add_program(${name}_test SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES}
                    acmap_test_support acmap_test_main)
  if(NOT arg_OPTIMIZED) # which is for tests that compute much themselves
    acmap_compile_quickly(${name}_test)
  endif()
  if(NOT "long" IN_LIST arg_LABELS AND NOT "product" IN_LIST arg_LABELS)
    if("tools" IN_LIST arg_LABELS OR "render" IN_LIST arg_LABELS)
      list(APPEND arg_LABELS product)
    elseif(NOT "threads" IN_LIST arg_LABELS OR NOT "usb" IN_LIST arg_LABELS)
      list(APPEND arg_LABELS sanitized)
    endif()
  endif()
  set(others)
  set(product_labels ${arg_LABELS} product)
  list(REMOVE_ITEM product_labels sanitized)
  list(TRANSFORM product_labels REPLACE "^threads$" all_threads)
  if(arg_THREAD_CASES)
    list(TRANSFORM arg_LABELS REPLACE "^threads$" all_threads)
    acmap_add_cases(${name} ${name}_threads "${arg_THREAD_CASES}" threads)
  endif()
  if(arg_PRODUCT_CASES)
    acmap_add_cases(${name} ${name}_product "${arg_PRODUCT_CASES}" ${product_labels})
    string(REGEX REPLACE "^--" "" others "-${arg_PRODUCT_CASES}")
  endif()
  acmap_add_cases(${name} ${name} "${others}" ${arg_LABELS})
endfunction()

# acmap_add_cases (<program> <name> <filter> <label>...): a ctest entry for some cases of a
# test program, or for all if the filter is empty.
function(acmap_add_cases program name filter)
  set(environment "ACMAP_TEST_DATA=${ACMAP_TEST_DATA}")
  if(filter)
    list(APPEND environment "GTEST_FILTER=${filter}")
  endif()
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/test"
             OUTPUT_VARIABLE folder)
  string(REGEX REPLACE "/.*" "" folder "${folder}")
  add_test(NAME ${name} COMMAND ${program}_test)
  set_tests_properties(${name} PROPERTIES LABELS "${ARGN};${folder}" ENVIRONMENT "${environment}"
                                          SKIP_RETURN_CODE 77)
  foreach(label IN LISTS ARGN)
    acmap_join(tests_${label} ${program}_test)
    acmap_join(tests_${label}_${folder} ${program}_test)
  endforeach()
endfunction()

# acmap_compile_quickly (<target>): the headers that most tests include are parsed once, and
# what a test does itself is not optimized.
function(acmap_compile_quickly target)
  if(NOT TARGET acmap_test_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/test_headers.cpp"
         CONTENT "int\nmain()\n{\n  return 0;\n}\n")
    acmap_add_program(acmap_test_headers SOURCES "${PROJECT_BINARY_DIR}/test_headers.cpp"
                      LIBRARIES acmap::core GTest::gmock nlohmann_json::nlohmann_json)
    target_compile_options(acmap_test_headers PRIVATE -O0 -pthread)
    acmap_define_as_pcl_io(acmap_test_headers)
    target_precompile_headers(
      acmap_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <nlohmann/json.hpp>
      <pcl/point_cloud.h> <pcl/point_types.h> <Eigen/Geometry> <algorithm> <filesystem>
      <fstream> <functional> <map> <set> <string> <thread> <vector>)
  endif()
  target_compile_options(${target} PRIVATE -O0 -pthread) # which some libraries add alone
  acmap_define_as_pcl_io(${target})
  target_precompile_headers(${target} REUSE_FROM acmap_test_headers)
endfunction()

# acmap_add_fuzzer (<name> SOURCES <file>... LIBRARIES <target>... [CORPUS <folder>]
#                   [MAX_LENGTH <bytes>])
#
# A libFuzzer target, which sets out from the inputs of corpus/<name>.tar.gz beside it, and
# from another folder if one is named; it takes words from dictionaries/<name>.dict where
# that is. With ACMAP_BUILD_FUZZERS it is a libFuzzer program that ctest runs over the inputs,
# and till ACMAP_FUZZ_SECONDS (5) are over; what it finds on the way stays in the build folder.
# Target fuzzers builds them all; property ACMAP_FUZZERS lists them with their options, for
# test/fuzz/long_run.sh. Without, it is a program that runs over the inputs once.
function(acmap_add_fuzzer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CORPUS;MAX_LENGTH" "SOURCES;LIBRARIES")
  set(seeds)
  set(packed "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}.tar.gz")
  if(EXISTS "${packed}")
    set(unpacked "${CMAKE_CURRENT_BINARY_DIR}/corpus/${name}")
    if(NOT EXISTS "${unpacked}" OR "${packed}" IS_NEWER_THAN "${unpacked}")
      file(REMOVE_RECURSE "${unpacked}")
      file(ARCHIVE_EXTRACT INPUT "${packed}" DESTINATION "${unpacked}" TOUCH)
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${packed}")
    list(APPEND seeds "${unpacked}")
  endif()
  list(APPEND seeds ${arg_CORPUS})
  if(ACMAP_BUILD_FUZZERS)
    acmap_add_libfuzzer_program()
  else()
    acmap_add_program(${name} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES}
                      acmap_fuzz_replay)
    add_test(NAME ${name} COMMAND ${name} ${seeds})
    set_tests_properties(${name} PROPERTIES LABELS "fuzz;sanitized")
    acmap_join(tests_sanitized ${name})
    acmap_join(tests_sanitized_fuzz ${name})
  endif()
endfunction()

# Reads name, seeds and the arguments of acmap_add_fuzzer.
macro(acmap_add_libfuzzer_program)
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
  list(APPEND options ${seeds})
  set(seconds 5)
  if(ACMAP_FUZZ_SECONDS)
    set(seconds ${ACMAP_FUZZ_SECONDS})
  endif()
  # The same inputs each time: new ones are for the long run.
  add_test(NAME ${name} COMMAND ${name} -seed=1 -max_total_time=${seconds}
                                "${found}" ${options})
  list(JOIN options " " options)
  set_property(GLOBAL APPEND_STRING PROPERTY ACMAP_FUZZERS "${name} ${options}\n")
  set_tests_properties(${name} PROPERTIES LABELS fuzz)
  acmap_join(fuzzers ${name})
endmacro()

# acmap_add_usb_test (<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...])
#
# As acmap_add_test, for a program with a UsbTestbed, and for the programs that it starts. The
# emulated camera has to keep pace: the program is optimized, and two processors are its own.
function(acmap_add_usb_test name)
  acmap_add_test(${name} ${ARGN} OPTIMIZED)
  target_link_libraries(${name}_test PRIVATE acmap_test_emulated_camera)
  acmap_sanitizer_runtime(libraries)
  list(APPEND libraries "${UMOCKDEV_PRELOAD_LIBRARY}")
  list(JOIN libraries ":" libraries)
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "LD_PRELOAD=${libraries}")
  set_property(TEST ${name} PROPERTY PROCESSORS 2)
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
