# actio_module(NAME [USES module...] [LINKS target...])
#
# One folder src/actio/NAME of headers is one INTERFACE target actio_NAME, exported as actio::NAME. USES names
# the modules that its headers may include; what those use comes along.
function(actio_module name)
  cmake_parse_arguments(arg "" "" "USES;LINKS" ${ARGN})
  add_library(actio_${name} INTERFACE)
  add_library(actio::${name} ALIAS actio_${name})
  set_target_properties(actio_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(actio_${name} INTERFACE cxx_std_20)
  target_include_directories(actio_${name} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM arg_USES PREPEND actio_)
  target_link_libraries(actio_${name} INTERFACE ${arg_USES} ${arg_LINKS})
  set(ACTIO_MODULES ${ACTIO_MODULES} actio_${name} PARENT_SCOPE)
endfunction()
