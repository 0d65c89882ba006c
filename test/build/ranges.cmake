# Checks that tools and Python give the values of users to the setters of the classes, and do
# not repeat their ranges: counts the ranges there, which are those of options that no class
# has (files, pictures, pace). ROOT: the repository.
cmake_minimum_required(VERSION 3.25)
find_program(grep grep REQUIRED)

# count_ranges (<maximum> <folder> <pattern>): lines with the pattern, except where the checks
# themselves are defined.
function(count_ranges maximum folder pattern)
  execute_process(COMMAND "${grep}" -rnE --include=*.h --include=*.cpp
                          --exclude=command_line.* "${pattern}" ${folder}
                  WORKING_DIRECTORY "${ROOT}" OUTPUT_VARIABLE found)
  string(REGEX MATCHALL "\n" ends "${found}")
  list(LENGTH ends count)
  if(count GREATER maximum)
    message(SEND_ERROR "${folder}: ${count} ranges, ${maximum} are allowed. If a class has the "
                       "value, call its setter (apps/common/setter_option.h, "
                       "python/setter_keyword.h):\n${found}")
  endif()
endfunction()

count_ranges(25 apps "CLI::(Range|Bound|Positive|NonNegative)|(positiveNumber|numberWithin) *\\(")
count_ranges(1 python "requireInRange|refuseArgument")
