# What a project gets from find_package(actio): actio::actio, and actio::numbers, actio::groups, ... one by
# one.
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_dependency(Eigen3 3.4)
find_dependency(Boost 1.74)
find_dependency(GSL)
find_dependency(GMP)
find_dependency(FFTW3)
list(REMOVE_ITEM CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
include("${CMAKE_CURRENT_LIST_DIR}/actio_targets.cmake")
