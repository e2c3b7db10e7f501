# Wrong calls fail to compile, and the compiler says why: each file of wrong_calls/ names, after "expected:", what
# must be in one of the first lines of the compiler's output that tell of an error; or it expects no error.
#
#   cmake -DCXX_COMPILER=... "-DFLAGS=-std=c++17;..." "-DINCLUDE_FOLDERS=...;..." -DSOURCE_FOLDER=.../wrong_calls
#         -DWORK_FOLDER=... -P test_wrong_calls.cmake
#
# FLAGS and INCLUDE_FOLDERS are lists. For compilers that know the options of GCC.

# A call may be instantiated in several ways; what is beyond these lines nobody reads.
set(number_of_lines 3)

set(arguments ${FLAGS})
foreach(folder ${INCLUDE_FOLDERS})
  list(APPEND arguments -isystem ${folder})
endforeach()

# What all files include is compiled once, if the compiler is GCC: clang++ wants other options for that.
execute_process(COMMAND ${CMAKE_COMMAND} -E make_directory ${WORK_FOLDER})
execute_process(COMMAND ${CXX_COMPILER} --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "clang")
  execute_process(COMMAND ${CXX_COMPILER} ${arguments} -x c++-header ${SOURCE_FOLDER}/mesh.h -o ${WORK_FOLDER}/mesh.h.gch
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "mesh.h does not compile")
  endif()
  list(APPEND arguments -I ${WORK_FOLDER} -include mesh.h)
endif()
list(APPEND arguments -fsyntax-only)

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

  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${CXX_COMPILER} ${arguments} ${source}
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
