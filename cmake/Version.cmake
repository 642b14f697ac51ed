# What `asperity --version` and summary.json say. Only one file is compiled anew
# when the revision changes.
set(ASPERITY_GIT_REVISION unknown)
find_package(Git QUIET)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty --exclude=*
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} OUTPUT_VARIABLE revision RESULT_VARIABLE status
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(status EQUAL 0)
    set(ASPERITY_GIT_REVISION ${revision})
  endif()
endif()
set(definitions ASPERITY_VERSION="${PROJECT_VERSION}" ASPERITY_GIT_REVISION="${ASPERITY_GIT_REVISION}"
  ASPERITY_BUILD_TYPE="${CMAKE_BUILD_TYPE}" ASPERITY_DEAL_II_VERSION="${DEAL_II_PACKAGE_VERSION}"
  ASPERITY_TRILINOS_VERSION="${DEAL_II_TRILINOS_VERSION}" ASPERITY_P4EST_VERSION="${DEAL_II_P4EST_VERSION}")
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/base/version.cc PROPERTIES
  COMPILE_DEFINITIONS "${definitions}")
