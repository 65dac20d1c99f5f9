# The fast Fourier transforms of FFTW in double precision, as target FFTW3::fftw3.
include("${CMAKE_CURRENT_LIST_DIR}/plain_library.cmake")
actio_plain_library(FFTW3 fftw3)
