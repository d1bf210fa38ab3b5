# Targets for those who work on swayaw: `format` lays out every C++ file, `format-check` fails when one is laid out
# otherwise, `tidy` asks clang-tidy for what .clang-tidy lists.
add_custom_target(format COMMAND cmake/format.sh WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
add_custom_target(format-check COMMAND cmake/format.sh --check WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
add_custom_target(tidy COMMAND cmake/tidy.sh ${PROJECT_BINARY_DIR} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
