# Wrong calls fail to compile, and the compiler says why: each file of wrong_calls/ names, after "expected:", what
# must be in one of the first lines of the compiler's output that tell of an error; or it expects no error.
#
#   cmake -DBUILD_FOLDER=... -DSOURCE_FOLDER=.../wrong_calls -P test_wrong_calls.cmake
#
# The target of a file is wrong_call_<its name>.

# A call may be instantiated in several ways; what is beyond these lines nobody reads.
set(number_of_lines 3)

file(GLOB sources ${SOURCE_FOLDER}/*.cpp)
list(LENGTH sources number_of_sources)
if(number_of_sources LESS 2)
  message(FATAL_ERROR "${SOURCE_FOLDER} has no files to compile")
endif()

foreach(source ${sources})
  get_filename_component(name ${source} NAME_WE)
  file(STRINGS ${source} expected REGEX "^// expected: " LIMIT_COUNT 1)
  if(NOT expected)
    message(SEND_ERROR "${name}: there is no line that begins with \"// expected: \"")
    continue()
  endif()
  string(REGEX REPLACE "^// expected: " "" expected "${expected}")

  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${CMAKE_COMMAND} --build ${BUILD_FOLDER} --target wrong_call_${name}
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(expected STREQUAL "no error")
    if(failed)
      message(SEND_ERROR "${name} does not compile:\n${output}")
    endif()
    continue()
  endif()
  if(NOT failed)
    message(SEND_ERROR "${name} compiles")
    continue()
  endif()

  # the text may hold what a list or a regular expression would take for its own
  string(REPLACE ";" "," output "${output}")
  string(REGEX MATCHALL "[^\n]*error[^\n]*" errors "${output}")
  list(LENGTH errors number)
  if(number GREATER number_of_lines)
    list(SUBLIST errors 0 ${number_of_lines} errors)
  endif()
  string(FIND "${errors}" "${expected}" position)
  if(position EQUAL -1)
    list(JOIN errors "\n" errors)
    message(SEND_ERROR "${name}: not \"${expected}\" but\n${errors}")
  endif()
endforeach()

message(STATUS "${number_of_sources} files")
