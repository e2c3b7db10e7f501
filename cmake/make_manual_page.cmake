# Makes a manual page of what a program prints with --help, whose lists of choices keep their lines:
#   cmake -DPROGRAM=<file> -DNAME=<name> -DVERSION=<version> -DOUTPUT=<file.1> -P make_manual_page.cmake

execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\\" "\\\\" help "${help}")
string(REPLACE "-" "\\-" help "${help}")

# Its first line says what the program does, its second how it is called.
string(REGEX MATCH "^([^\n]*)\\.\nUsage: ([^\n]*)\n(.*)$" is_read "${help}")
if(NOT is_read)
  message(FATAL_ERROR "The help of ${NAME} does not begin as expected")
endif()
string(SUBSTRING "${CMAKE_MATCH_1}" 0 1 first_letter)
string(SUBSTRING "${CMAKE_MATCH_1}" 1 -1 purpose)
string(TOLOWER "${first_letter}" first_letter)
set(usage "${CMAKE_MATCH_2}")
set(rest "\n${CMAKE_MATCH_3}")

# Headings of groups, examples and exit codes begin in the first column, options in the third. Descriptions are lines of
# their own, or follow after blanks. Of their lines, those that begin with a choice and a colon stay lines.
string(REGEX REPLACE "\n([A-Z][A-Za-z' ]+):\n" "\n.SS \\1\n" rest "${rest}")
string(REGEX REPLACE "\n\\.SS (Examples|Exit status)\n" "\n.SH \\1\n" rest "${rest}")
string(REGEX REPLACE "\n      +(\\.?[a-z0-9\\\\-]+: )" "\n.br\n\\1" rest "${rest}")
string(REGEX REPLACE "\n      +" "\n" rest "${rest}")
string(REGEX REPLACE "\n  ([^ \n][^\n]*)" "\n.TP\n.B \\1" rest "${rest}")
string(REGEX REPLACE "(\n\\.B [^\n]*[^ \n])   *([^ \n])" "\\1\n\\2" rest "${rest}")
string(REGEX REPLACE "(\n\\.B [^\n]*)\n\\.br\n" "\\1\n" rest "${rest}")
string(REGEX REPLACE "\n\n+" "\n" rest "${rest}")
string(REGEX REPLACE "\n\\.br\n([.'])" "\n.br\n\\\\&\\1" rest "${rest}")

string(TOUPPER "${NAME}" title)
file(WRITE ${OUTPUT} ".TH ${title} 1 \"\" \"Protrusion_segmentation ${VERSION}\" \"User Commands\"
.SH Name
${NAME} \\- ${first_letter}${purpose}
.SH Synopsis
${usage}
.SH Options${rest}.SH See also
Where it is installed as a Debian package, examples in C++ are in /usr/share/doc/protrusion\\-segmentation/examples, and
the manual is the package protrusion\\-segmentation\\-doc.
")
