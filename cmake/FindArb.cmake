# The library of ball arithmetic, as target Arb::arb: for checks and tests. Debian names it flint-arb; from
# FLINT 3 on it is a part of FLINT.
find_path(ARB_INCLUDE_DIR arb.h PATH_SUFFIXES flint)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_library(ARB_LIBRARY NAMES flint-arb arb flint)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS ARB_LIBRARY ARB_INCLUDE_DIR FLINT_LIBRARY FLINT_INCLUDE_DIR)
if(Arb_FOUND AND NOT TARGET Arb::arb)
  add_library(Arb::arb UNKNOWN IMPORTED)
  set_target_properties(Arb::arb PROPERTIES
    IMPORTED_LOCATION "${ARB_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${ARB_INCLUDE_DIR};${FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${FLINT_LIBRARY}")
endif()
mark_as_advanced(ARB_INCLUDE_DIR FLINT_INCLUDE_DIR ARB_LIBRARY FLINT_LIBRARY)
