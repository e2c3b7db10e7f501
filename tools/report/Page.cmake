# protrusion_page(VARIABLE PROGRAM...)
#
# Puts the page of page/page.html together, with three.js and the scripts of the report followed by PROGRAM..., files of scripts.
# Before, the variables THREE_JS and THREE_JS_LICENCE name its files; PAGE_STYLE, PAGE_BEGIN, PAGE_HEAD, PAGE_OPTIONS and PAGE_END
# are what a page has besides, REPORT_SAVING is what it has in place of the report's buttons, and REPORT_DATA what it shows.

set(protrusion_page_parts ${CMAKE_CURRENT_LIST_DIR}/page)
set(protrusion_page_scripts Model.js Editor.js Exporter.js View.js Panel.js Report.js)
list(TRANSFORM protrusion_page_scripts PREPEND ${protrusion_page_parts}/)

# As text in a page.
function(protrusion_read_text file variable)
  file(READ ${file} text)
  string(REPLACE "&" "&amp;" text "${text}")
  string(REPLACE "<" "&lt;" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

function(protrusion_page variable)
  file(READ ${protrusion_page_parts}/page.css REPORT_STYLE)
  file(READ ${THREE_JS} REPORT_THREE)
  protrusion_read_text(${THREE_JS_LICENCE} REPORT_LICENCE)
  if(NOT DEFINED REPORT_SAVING)
    file(READ ${protrusion_page_parts}/saving.html REPORT_SAVING)
  endif()
  set(REPORT_PROGRAM)
  foreach(program ${protrusion_page_scripts} ${ARGN})
    file(READ ${program} text)
    string(APPEND REPORT_PROGRAM "${text}")
  endforeach()
  file(READ ${protrusion_page_parts}/page.html page)
  string(CONFIGURE "${page}" page @ONLY)
  set(${variable} "${page}" PARENT_SCOPE)
endfunction()
