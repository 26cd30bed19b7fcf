# The README shows the example, what it prints, and the Stribeck table as the program prints it; docs/c.md
# its programs.
# Run as: cmake -DROOT=<source folder> -DEXAMPLE=<program> [-DRACEWAY=<program> -DWORK=<folder>] -P readme.cmake
cmake_minimum_required(VERSION 3.22)

function(expect_in page what text)
  file(READ ${ROOT}/${page} shown)
  string(STRIP "${text}" text)
  string(FIND "${shown}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${page} does not show ${what} as it is now:\n${text}")
  endif()
endfunction()

function(output_of)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(READ ${ROOT}/tests/install/example.cpp example)
expect_in(README.md "tests/install/example.cpp" "${example}")
output_of(${EXAMPLE})
expect_in(README.md "the output of the example" "${output}")
if(RACEWAY)
  file(MAKE_DIRECTORY ${WORK})
  output_of(${RACEWAY} new "S 6014 C" -o ${WORK}/my.toml --force)
  output_of(${RACEWAY} table ${WORK}/my.toml --speed 0:12000:2000 --axial-load 100,300,900)
  expect_in(README.md "the Stribeck table" "${output}")
endif()
foreach(program example.c example.f90)
  file(READ ${ROOT}/tests/install/${program} text)
  expect_in(docs/c.md tests/install/${program} "${text}")
endforeach()
