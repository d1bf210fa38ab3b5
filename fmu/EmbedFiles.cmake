# Writes a C++ file that holds the shared library of the unit, those that it is linked to beside the ones that every
# system with a C++ program has, and the licences.
#   cmake -D LIBRARY=… -D FOLDER=binaries/linux64 -D LICENCES=FILE;FILE -D OUTPUT=… -P EmbedFiles.cmake
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${LIBRARY} RESOLVED_DEPENDENCIES_VAR linked
  PRE_EXCLUDE_REGEXES "^lib(c|m|stdc\\+\\+|gcc_s|pthread)\\.so" "^ld-linux")

set(objects "")
set(rows "")
set(index 0)
macro(embed file name)
  string(APPEND objects "asm(\".pushsection .rodata\\nswayaw_file_${index}: .incbin \\\"${file}\\\"\\nswayaw_end_${index}: .popsection\");\n"
    "extern \"C\" const char swayaw_file_${index}[], swayaw_end_${index}[];\n")
  string(APPEND rows "      {\"${name}\", {swayaw_file_${index}, static_cast<std::size_t>(swayaw_end_${index} - swayaw_file_${index})}},\n")
  math(EXPR index "${index} + 1")
endmacro()

foreach(file IN LISTS LIBRARY linked)
  get_filename_component(name ${file} NAME)
  embed(${file} ${FOLDER}/${name})
endforeach()
foreach(file IN LISTS LICENCES)
  get_filename_component(name ${file} NAME)
  embed(${file} documentation/licenses/${name})
endforeach()

file(WRITE ${OUTPUT} "#include \"contents.hpp\"\n\n${objects}
namespace swayaw::fmu {

std::span<const Content> contents() {
  static const Content all[] = {
${rows}  };
  return all;
}

}  // namespace swayaw::fmu
")
