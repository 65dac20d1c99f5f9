# Install and export: after `cmake --install`, find_package(actio) gives actio::actio, one target per module
# and the core, actio::core, which they link.
include(CMakePackageConfigHelpers)
set(actio_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/actio)

install(TARGETS actio actio_core ${ACTIO_MODULES} EXPORT actio_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/actio DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp"
        PATTERN "bodies" EXCLUDE)
install(EXPORT actio_targets NAMESPACE actio:: DESTINATION ${actio_config_dir})

write_basic_package_version_file(actioConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/actioConfig.cmake cmake/FindGMP.cmake cmake/FindFFTW3.cmake cmake/plain_library.cmake "${CMAKE_CURRENT_BINARY_DIR}/actioConfigVersion.cmake"
        DESTINATION ${actio_config_dir})
if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/data")
  install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/actio/data)
endif()
