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
