# The GNU library of floating-point numbers of any precision, as target MPFR::mpfr: for checks and tests.
include("${CMAKE_CURRENT_LIST_DIR}/plain_library.cmake")
actio_plain_library(MPFR mpfr)
