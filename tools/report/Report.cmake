# The page that `segment_by_protrusions --report` writes, with three.js as Debian's libjs-three installs
# it, in a header. Without three.js the tool is built without it.

include(${PROJECT_SOURCE_DIR}/cmake/Embed_text.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Page.cmake)

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

# The mesh comes between the two halves.
set(gap "(the data)")
set(REPORT_DATA "${gap}")
protrusion_page(page ${protrusion_page_parts}/main.js)
string(FIND "${page}" "${gap}" begin_length)
string(LENGTH "${gap}" gap_length)
math(EXPR end_begin "${begin_length} + ${gap_length}")
string(SUBSTRING "${page}" 0 ${begin_length} page_begin)
string(SUBSTRING "${page}" ${end_begin} -1 page_end)

set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_page)
protrusion_embed_text(${folder}/report_page.h report_page_begin page_begin report_page_end page_end)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${protrusion_page_scripts} ${protrusion_page_parts}/main.js ${protrusion_page_parts}/page.html
             ${protrusion_page_parts}/saving.html ${protrusion_page_parts}/page.css ${THREE_JS} ${THREE_JS_LICENCE})
target_sources(segment_by_protrusions PRIVATE report/report.cpp)
target_include_directories(segment_by_protrusions PRIVATE ${folder})
