# The GNU multiple precision library, as target GMP::gmp: the exact rationals are made of it.
include("${CMAKE_CURRENT_LIST_DIR}/plain_library.cmake")
actio_plain_library(GMP gmp)
