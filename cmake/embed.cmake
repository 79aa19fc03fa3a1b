# Writes a C++ source that defines string_views of the contents of files.
# Usage: cmake -DOUTPUT=<source> -DHEADER=<header that declares them> -DNAMESPACE=<their namespace>
#        "-DFILES=<constant>=<file>;..." -P embed.cmake
cmake_minimum_required(VERSION 3.25)

set(text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(entry IN LISTS FILES)
  string(REGEX MATCH "^([A-Za-z0-9_]+)=(.+)$" entry "${entry}")
  set(name ${CMAKE_MATCH_1})
  file(READ "${CMAKE_MATCH_2}" bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND text "static constexpr char ${name}Bytes[] = {\n${bytes}'\\0'};\n"
                     "const std::string_view ${name}{${name}Bytes, sizeof(${name}Bytes) - 1};\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}}\n")
