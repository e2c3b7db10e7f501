# Fails unless all code that README, CONTRIBUTING and the manuals show is compiled by the build: a block in
# Markdown must be, word for word, part of a file that is; the manuals show code by including examples only.
# The definition SOURCE_FOLDER comes from the command line.

file(GLOB_RECURSE compiled_files
     ${SOURCE_FOLDER}/examples/Protrusion_segmentation/*.cpp
     ${SOURCE_FOLDER}/integration_test/installed_package/*)
set(compiled "")
foreach(file ${compiled_files})
  file(READ ${file} text)
  string(APPEND compiled "${text}")
endforeach()

foreach(name README.md CONTRIBUTING.md)
  file(READ ${SOURCE_FOLDER}/${name} text)
  foreach(language cpp cmake)
    set(rest "${text}")
    string(FIND "${rest}" "```${language}\n" begin)
    while(NOT begin EQUAL -1)
      string(LENGTH "```${language}\n" length)
      math(EXPR begin "${begin} + ${length}")
      string(SUBSTRING "${rest}" ${begin} -1 rest)
      string(FIND "${rest}" "```" end)
      string(SUBSTRING "${rest}" 0 ${end} block)
      string(FIND "${compiled}" "${block}" position)
      if(position EQUAL -1)
        message(FATAL_ERROR "${name} shows code that is not compiled:\n${block}")
      endif()
      string(FIND "${rest}" "```${language}\n" begin)
    endwhile()
  endforeach()
endforeach()

file(GLOB_RECURSE documents
     ${SOURCE_FOLDER}/include/*.h
     ${SOURCE_FOLDER}/doc/Protrusion_segmentation/*.txt
     ${SOURCE_FOLDER}/doc/Protrusion_segmentation/Concepts/*.h)
foreach(file ${documents})
  file(READ ${file} text)
  foreach(mark "\\code" "~~~" "```")
    string(FIND "${text}" "${mark}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} shows code that is not compiled; include an example instead")
    endif()
  endforeach()
endforeach()
