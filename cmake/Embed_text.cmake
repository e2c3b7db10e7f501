# protrusion_embed_text(HEADER NAME TEXT [NAME TEXT]...)
#
# Writes a C++ header with an array of strings `NAME` for each TEXT; one after the other they are the
# text. Compilers need not accept a literal of more than 64 KiB, so there are several, some of which may
# begin or end within a character.
function(protrusion_embed_text header)
  set(piece_length 8000)
  string(CONCAT content
    "#pragma once\n"
    "#ifdef __clang__\n"
    "#pragma clang diagnostic ignored \"-Winvalid-source-encoding\"\n"
    "#endif\n")
  while(ARGN)
    list(POP_FRONT ARGN name variable)
    string(APPEND content "inline constexpr const char* ${name}[] = {\n")
    string(LENGTH "${${variable}}" length)
    set(begin 0)
    while(begin LESS length)
      string(SUBSTRING "${${variable}}" ${begin} ${piece_length} piece)
      string(APPEND content "R\"~~~(${piece})~~~\",\n")
      math(EXPR begin "${begin} + ${piece_length}")
    endwhile()
    string(APPEND content "\"\"};\n")
  endwhile()
  file(WRITE ${header}.new "${content}")
  file(COPY_FILE ${header}.new ${header} ONLY_IF_DIFFERENT)
  file(REMOVE ${header}.new)
endfunction()
