# Writes what a browser knows the scripts of the pages by: SHA-256 of each, put together as scripts.html has it.
#
#   cmake -D FOLDER=… -D PLOTLY=… -D OUTPUT=… -P script_hashes.cmake
file(READ ${FOLDER}/scripts.html frame)
string(FIND "${frame}" "<script>" begin REVERSE)
string(FIND "${frame}" "</script>" end REVERSE)
math(EXPR begin "${begin} + 8")
math(EXPR length "${end} - ${begin}")
string(SUBSTRING "${frame}" ${begin} ${length} frame)
file(READ ${FOLDER}/page.js helpers)
string(REPLACE "{{helpers}}" "${helpers}" frame "${frame}")

file(SHA256 ${PLOTLY} hash)
set(text "#pragma once\n\n#include <string_view>\n\n/// SHA-256 in hexadecimal digits.\nnamespace swayaw::script_hash {\n\n")
string(APPEND text "inline constexpr std::string_view plotly = \"${hash}\";\n")
foreach(page check compare diagnose loop trial)
  file(READ ${FOLDER}/${page}.js script)
  string(REPLACE "{{script}}" "${script}" whole "${frame}")
  string(SHA256 hash "${whole}")
  string(APPEND text "inline constexpr std::string_view ${page} = \"${hash}\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}\n}  // namespace swayaw::script_hash\n")
