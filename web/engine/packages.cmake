# The libraries of this project for em++, which must see neither the headers of the system's C library nor compiled
# libraries: folders with the headers of one library each, and the sources of muParser and Ceres.
set(outside ${PROJECT_BINARY_DIR}/outside)
set(sources ${outside}/sources)
if(NOT EXISTS ${sources}/ceres-solver OR NOT EXISTS ${sources}/muparser)
  message(STATUS "Fetching the sources of muParser and Ceres from Debian's archive")
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/fetch_sources ${sources} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "web/engine/fetch_sources failed: it needs apt-get, dpkg-source (Debian: dpkg-dev) and Debian's archive")
  endif()
endif()

# headers(target folder [name in /usr/include])
function(headers target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  foreach(name IN LISTS ARGN)
    if(NOT EXISTS /usr/include/${name})
      message(FATAL_ERROR "The engine of the workbench needs /usr/include/${name}: see scripts/packages.txt")
    endif()
    file(MAKE_DIRECTORY ${outside}/include)
    file(CREATE_LINK /usr/include/${name} ${outside}/include/${name} SYMBOLIC)
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${outside}/include
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${outside}/include)
endfunction()
headers(Boost::headers boost)
headers(fmt::fmt fmt)
headers(tomlplusplus::tomlplusplus toml++)
headers(nlohmann_json::nlohmann_json nlohmann)
headers(CLI11::CLI11 CLI)
headers(Eigen3::Eigen)
set_target_properties(Eigen3::Eigen PROPERTIES INTERFACE_INCLUDE_DIRECTORIES /usr/include/eigen3)
headers(xsimd xsimd)
set(XSIMD_INCLUDE_DIR ${outside}/include)
headers(spectra Spectra)
set(SPECTRA_INCLUDE_DIR ${outside}/include)
set_target_properties(fmt::fmt PROPERTIES INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY)
set_target_properties(tomlplusplus::tomlplusplus PROPERTIES INTERFACE_COMPILE_DEFINITIONS TOML_HEADER_ONLY=1)

# WebAssembly with its own exceptions, and 128-bit vectors by the names of SSE2.
# Eigen knows no more of SSE2 than that it is there: its assembler is that of another machine.
add_compile_options(-fwasm-exceptions -msimd128 -msse2)
add_compile_definitions(EIGEN_DONT_VECTORIZE)
add_link_options(-fwasm-exceptions)

# One thread: loops in their order.
add_library(TBB::tbb INTERFACE IMPORTED GLOBAL)
set_target_properties(TBB::tbb PROPERTIES INTERFACE_INCLUDE_DIRECTORIES
  "${CMAKE_CURRENT_LIST_DIR}/library;${PROJECT_SOURCE_DIR}/tests/threads")

# outside_library(name folder_of_headers sources...): warnings are its authors' business.
function(outside_library name folders)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${ARGN})
  target_include_directories(${name} SYSTEM PUBLIC ${folders})
  target_compile_features(${name} PUBLIC cxx_std_17)
  target_compile_options(${name} PRIVATE -w)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()

file(GLOB muparser_sources ${sources}/muparser/src/muParser*.cpp)
list(FILTER muparser_sources EXCLUDE REGEX "muParser(DLL|Test)[.]cpp$")
outside_library(muparser ${sources}/muparser/include ${muparser_sources})
target_compile_definitions(muparser PUBLIC MUPARSER_STATIC)
add_library(muparser::muparser ALIAS muparser)

# Dense solvers of Ceres are all that is used.
file(WRITE ${outside}/ceres/ceres/internal/config.h
"#define CERES_NO_SUITESPARSE
#define CERES_NO_CXSPARSE
#define CERES_NO_ACCELERATE_SPARSE
#define CERES_NO_LAPACK
#define CERES_NO_CUDA
#define CERES_NO_EIGEN_METIS
#define CERES_NO_THREADS
#define CERES_RESTRICT_SCHUR_SPECIALIZATION
#define CERES_NO_EXPORT_HEADER
")
file(WRITE ${outside}/ceres/ceres/internal/export.h
"#define CERES_EXPORT
#define CERES_NO_EXPORT
#define CERES_DEPRECATED
")
set(ceres ${sources}/ceres-solver)
file(GLOB ceres_sources ${ceres}/internal/ceres/*.cc ${ceres}/internal/ceres/miniglog/glog/*.cc
  ${ceres}/internal/ceres/generated/*_d_d_d.cc)
# The covariance, which nothing asks for, takes the longest of all to compile.
list(FILTER ceres_sources EXCLUDE REGEX "/covariance(_impl)?[.]cc$")
list(FILTER ceres_sources EXCLUDE REGEX "(_test|test_utils?|gmock_[a-z_]*|benchmark)[.]cc$")
outside_library(ceres "${outside}/ceres;${ceres}/include;${ceres}/internal/ceres/miniglog" ${ceres_sources})
target_include_directories(ceres SYSTEM PRIVATE ${ceres}/internal /usr/include/eigen3)
target_compile_definitions(ceres PRIVATE MAX_LOG_LEVEL=-1)
target_compile_options(ceres PRIVATE -O1)
add_library(Ceres::ceres ALIAS ceres)
add_library(glog::glog ALIAS ceres)
