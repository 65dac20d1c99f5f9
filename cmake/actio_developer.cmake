# How the project builds its own programs: warnings, optimisation, precompiled headers, the log of compile
# times.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(ACTIO_REPORT "${PROJECT_BINARY_DIR}/report")
file(MAKE_DIRECTORY "${ACTIO_REPORT}/programs" "${ACTIO_REPORT}/checks")

# Each compile is timed, and cached where ccache is there.
find_program(CCACHE ccache)
find_program(GNU_TIME time)
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  if(GNU_TIME)
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER "${PROJECT_SOURCE_DIR}/cmake/compile_log.sh" "${ACTIO_REPORT}/compile_log.tsv")
  endif()
  if(CCACHE)
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE}")
  endif()
  # The core is declared before.
  set_target_properties(actio_core PROPERTIES CXX_COMPILER_LAUNCHER "${CMAKE_CXX_COMPILER_LAUNCHER}")
endif()

# GCC collects no garbage before it holds two gigabytes, which is more than a unit may take. That saves 4 % of
# the time of most units for a tenth more memory, and up to a third for the largest, for two fifths more.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=2000000>)
endif()

# Gold links our programs, of which there are more than a hundred, in a third of the time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold ACTIO_LINKS_WITH_GOLD)
if(ACTIO_LINKS_WITH_GOLD)
  add_link_options(-fuse-ld=gold)
endif()

find_package(Boost 1.74 REQUIRED COMPONENTS unit_test_framework)

find_package(ZLIB REQUIRED)  # pictures are packed with it

# What the reader of a chapter's program is told, and the pictures it draws.
# Compiled once: in each program of a chapter it would take a second or two.
file(GLOB book CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/book/*.cpp")
add_library(actio_book STATIC ${book})
target_include_directories(actio_book PUBLIC "${PROJECT_SOURCE_DIR}/src")
target_compile_features(actio_book PUBLIC cxx_std_20)
target_compile_options(actio_book PRIVATE -Wall -Wextra)
target_link_libraries(actio_book PRIVATE ZLIB::ZLIB)
set_target_properties(actio_book PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD ON)

# actio_own(TARGET LEVEL): our own code, at -O2 (LEVEL fast), or at -Og where multiprecision dominates (LEVEL
# brief). There -Og runs as fast as -O1 over the rationals and within a fifth of it in 50 digits, and compiles
# in two thirds of the time. With OWN_HEADERS after it the target has precompiled headers of its own, or none.
function(actio_own target level)
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  # The same for all, or the precompiled headers do not fit.
  target_compile_definitions(${target} PRIVATE BOOST_TEST_DYN_LINK BOOST_UNIT_TEST_FRAMEWORK_DYN_LINK BOOST_ALL_NO_LIB)
  if(level STREQUAL "brief")
    # With assertions, that of the standard library's containers included: an index outside ends a test.
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og -UNDEBUG>)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
  if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
  if(TARGET actio_precompiled_${level} AND NOT target STREQUAL "actio_precompiled_${level}" AND NOT "OWN_HEADERS" IN_LIST ARGN)
    target_precompile_headers(${target} REUSE_FROM actio_precompiled_${level})
  endif()
endfunction()

# actio_together(OUT NAME BYTES SOURCE...): sources that compile SOURCE... as many at a time as BYTES of text
# hold, into the variable OUT (tools/together.awk says how, and for which sources). What several of them
# instantiate is compiled once, in two thirds of the time. Those that add to a namespace of others stay as
# they are, and those that say of themselves, in a line of their own, that they are `// In a unit of its own`,
# as large as a unit may be.
find_program(AWK awk REQUIRED)
function(actio_together out name bytes)
  set(result "")
  set(batch "")
  set(held 0)
  set(number 0)
  set(rule "${PROJECT_SOURCE_DIR}/cmake/tools/together.awk")
  list(SORT ARGN COMPARE NATURAL)
  foreach(source IN LISTS ARGN ITEMS "")
    if(source)
      file(STRINGS "${source}" stays REGEX "^(// In a unit of its own|namespace [a-zA-Z]|extern |template (class|struct|<>))")
      if(stays)
        list(APPEND result "${source}")
        continue()
      endif()
      file(SIZE "${source}" size)
      math(EXPR held "${held} + ${size}")
    endif()
    if(batch AND (NOT source OR held GREATER bytes))
      math(EXPR number "${number} + 1")
      set(file "${CMAKE_CURRENT_BINARY_DIR}/together/${name}_${number}.cpp")
      file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/together")
      add_custom_command(OUTPUT "${file}" COMMAND ${AWK} -f "${rule}" ${batch} > "${file}" DEPENDS "${rule}" ${batch} VERBATIM)
      list(APPEND result "${file}")
      set(batch "")
      set(held ${size})
    endif()
    list(APPEND batch ${source})
  endforeach()
  set(${out} ${result} PARENT_SCOPE)
endfunction()

# The headers that nearly every unit needs, compiled once per level: at -O2 the standard library's and
# Eigen's, at -Og, where all the tests are, Boost.Test (which every target that includes it must link) and the
# library's headers for bodies as well: reading those takes two seconds, and there are over a hundred units.
if(ACTIO_BUILD_CHAPTERS OR ACTIO_BUILD_CHECKS OR ACTIO_BUILD_TESTS)
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/precompiled.cpp" CONTENT "")
  foreach(level IN ITEMS fast brief)
    add_library(actio_precompiled_${level} OBJECT "${PROJECT_BINARY_DIR}/precompiled.cpp")
    target_link_libraries(actio_precompiled_${level} PRIVATE actio_groups)
    actio_own(actio_precompiled_${level} ${level})
    target_precompile_headers(actio_precompiled_${level} PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
  endforeach()
  set(own "")
  foreach(module IN ITEMS numbers groups variational reduction groupoid instruments rigid_body)
    file(GLOB headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/actio/${module}/*.hpp")
    list(APPEND own ${headers})
  endforeach()
  target_precompile_headers(actio_precompiled_brief PRIVATE <boost/test/unit_test.hpp> ${own})
endif()
