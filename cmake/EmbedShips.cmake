# Writes a C++ source with the text of every ship file of a folder.
#   cmake -D FOLDER=ships -D OUTPUT=published_ship_texts.cpp -P EmbedShips.cmake
file(GLOB files ${FOLDER}/*.toml)
list(SORT files)
set(source "#include \"swayaw/nonlinear/published_ships.hpp\"\n\nnamespace swayaw::inline nonlinear {\nnamespace {\n\nconstexpr PublishedShip ships[] = {\n")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND source "{\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
string(APPEND source "};\n\n}  // namespace\n\nstd::span<const PublishedShip> published_ships() { return ships; }\n\n}  // namespace swayaw\n")
file(WRITE ${OUTPUT} "${source}")
