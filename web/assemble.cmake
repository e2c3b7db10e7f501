# Puts the page together: cmake -DPROGRAM=segment_in_page.js -DOUTPUT=segment.html -DZLIB_SOURCE=FOLDER -P assemble.cmake
# PROGRAM is what Emscripten made, the compiled program in it.

include(${CMAKE_CURRENT_LIST_DIR}/../tools/report/Page.cmake)

set(parts ${CMAKE_CURRENT_LIST_DIR}/page)
set(documents /usr/share/doc)
set(THREE_JS /usr/share/javascript/three/three.min.js)
set(THREE_JS_LICENCE ${documents}/libjs-three/copyright)

set(LICENCES "The program in this page contains CGAL (GPL 3 or later), Eigen and Spectra (MPL 2.0), Boost (Boost Software \
License 1.0), the C and C++ libraries of Emscripten (MIT, Apache 2.0 with LLVM exceptions), and these:\n")
foreach(package nlohmann-json3-dev libcli11-dev libtinygltf-dev zlib1g-dev)
  protrusion_read_text(${documents}/${package}/copyright text)
  string(APPEND LICENCES "\n${package}\n\n${text}")
endforeach()

foreach(part style:page.css begin:begin.html options:options.html)
  string(REGEX MATCH "^([a-z]+):(.*)$" matched ${part})
  string(TOUPPER ${CMAKE_MATCH_1} name)
  file(READ ${parts}/${CMAKE_MATCH_2} PAGE_${name})
endforeach()
string(CONFIGURE "${PAGE_BEGIN}" PAGE_BEGIN @ONLY)
set(PAGE_HEAD "<button type=\"button\" id=\"new_mesh\">another mesh</button>\n")
file(READ ${parts}/saving.html REPORT_SAVING)

file(READ ${PROGRAM} program)
file(READ ${parts}/worker.js worker)
string(APPEND program "\n${worker}")
if("${program}" MATCHES "</script|<!--")
  message(FATAL_ERROR "${PROGRAM} looks like the end of a script")
endif()
set(PAGE_END "<script type=\"text/plain\" id=\"program\">\n${program}</script>\n")
set(REPORT_DATA null)

protrusion_page(page ${parts}/Program.js ${parts}/Options.js ${parts}/Segmenting_report.js ${parts}/main.js)
string(REPLACE "<title>Protrusions</title>" "<title>Protrusion segmentation</title>" page "${page}")
file(WRITE ${OUTPUT} "${page}")
file(SIZE ${OUTPUT} size)
message(STATUS "${OUTPUT}: ${size} bytes")
