# Bundles the page of reports into report_template.cpp, in the build tree. Sets page_source.
include(${PROJECT_SOURCE_DIR}/cmake/npm_packages.cmake)
find_node()
set(page_dir ${CMAKE_CURRENT_SOURCE_DIR}/page)
set(packages_dir ${CMAKE_CURRENT_BINARY_DIR}/page)
set(page_source ${CMAKE_CURRENT_BINARY_DIR}/report_template.cpp)
npm_packages(${page_dir} ${packages_dir})
file(GLOB page_files CONFIGURE_DEPENDS ${page_dir}/src/*.ts)
add_custom_command(OUTPUT ${page_source}
  COMMAND ${NODE} ${page_dir}/bundle.mjs ${packages_dir} ${page_source}
  DEPENDS ${packages_dir}/packages.stamp ${page_files} ${page_dir}/bundle.mjs
    ${page_dir}/one_page.mjs ${page_dir}/page.html ${page_dir}/style.css ${page_dir}/licences.txt
  COMMENT "Bundling the page of reports"
  VERBATIM)
