# Debian packages of what is installed: raceway (command, man pages, completions, data), libraceway-dev (headers, libraries
# of C++ and C) and with -DRACEWAY_PYTHON=ON python3-raceway. scripts/package makes and tries them.
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/raceway RENAME copyright COMPONENT command)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/raceway COMPONENT command)
# The rig of the first page.
install(DIRECTORY tests/hidden_effect/rigs/dev-03/ DESTINATION ${CMAKE_INSTALL_DATADIR}/raceway/examples/rig COMPONENT command)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/raceway/docs COMPONENT command PATTERN site EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libraceway-dev RENAME copyright COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the raceway authors <raceway@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${PROJECT_HOMEPAGE_URL}")

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME raceway)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION science)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "Computes contact angles, loads, stiffness and friction torque of angular contact ball bearings, alone, in sets
and in a whole spindle, holds them against measurements and says which physical effect a model lacks.")

# What the package files in lib/cmake/raceway ask for, and what its public headers include.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libraceway-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "raceway (= ${PROJECT_VERSION}), libboost-math-dev, libceres-dev, libeigen3-dev, libfmt-dev, libmuparser-dev, libtbb-dev, libtomlplusplus-dev, nlohmann-json3-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and static libraries of C++20, and a shared library with the functions of raceway.h for C and others.")

if(RACEWAY_PYTHON)
  find_package(Python REQUIRED COMPONENTS Interpreter)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-raceway)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "raceway (= ${PROJECT_VERSION}), python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, python3-matplotlib")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The package raceway: models, records and results over numpy and pandas, pictures for papers.")
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-raceway RENAME copyright COMPONENT python)
endif()
include(CPack)
