# The page that `segment_by_protrusions --report` writes, with three.js as Debian's libjs-three installs
# it, in a header. Without three.js the tool is built without it.

include(${PROJECT_SOURCE_DIR}/cmake/Embed_text.cmake)

find_file(THREE_JS three.min.js PATH_SUFFIXES share/javascript/three
          DOC "three.js, a version that defines the global THREE")
find_file(THREE_JS_LICENCE copyright PATH_SUFFIXES share/doc/libjs-three
          DOC "The licence of three.js, which the page shows")
mark_as_advanced(THREE_JS THREE_JS_LICENCE)

if(NOT THREE_JS OR NOT THREE_JS_LICENCE)
  message(STATUS "three.js not found (Debian: libjs-three): segment_by_protrusions has no --report")
  target_sources(segment_by_protrusions PRIVATE report/no_report.cpp)
  return()
endif()

set(parts ${CMAKE_CURRENT_LIST_DIR}/page)
file(READ ${parts}/page.css REPORT_STYLE)
file(READ ${THREE_JS} REPORT_THREE)
file(READ ${THREE_JS_LICENCE} REPORT_LICENCE)
string(REPLACE "&" "&amp;" REPORT_LICENCE "${REPORT_LICENCE}")
string(REPLACE "<" "&lt;" REPORT_LICENCE "${REPORT_LICENCE}")
set(programs ${parts}/Model.js ${parts}/Editor.js ${parts}/Exporter.js ${parts}/View.js ${parts}/Panel.js ${parts}/main.js)
foreach(program ${programs})
  file(READ ${program} text)
  string(APPEND REPORT_PROGRAM "${text}")
endforeach()

# The mesh comes between the two halves.
file(READ ${parts}/page.html page)
string(FIND "${page}" "@REPORT_DATA@" begin_length)
string(LENGTH "@REPORT_DATA@" gap)
math(EXPR end_begin "${begin_length} + ${gap}")
string(SUBSTRING "${page}" 0 ${begin_length} page_begin)
string(SUBSTRING "${page}" ${end_begin} -1 page_end)
string(CONFIGURE "${page_begin}" page_begin @ONLY)
string(CONFIGURE "${page_end}" page_end @ONLY)

set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_page)
protrusion_embed_text(${folder}/report_page.h report_page_begin page_begin report_page_end page_end)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${programs} ${parts}/page.html ${parts}/page.css ${THREE_JS} ${THREE_JS_LICENCE})
target_sources(segment_by_protrusions PRIVATE report/report.cpp report/report_data.cpp)
target_include_directories(segment_by_protrusions PRIVATE ${folder})
