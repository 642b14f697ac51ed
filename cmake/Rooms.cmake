# Flags that every target shares: deal.II's own, warnings, and sanitizers on request.
function(asperity_flags target)
  deal_ii_setup_target(${target})
  target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR}/include)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wno-unused-parameter)
  # Open MPI's C++ classes, which nobody uses, would be compiled in each source.
  target_compile_definitions(${target} PRIVATE OMPI_SKIP_MPICXX=1)
  # deal.II's own flags ask for debug information in Release, too: a fifth of
  # the build time and most of its disk space.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-g0>)
  if(ASPERITY_SANITIZE)
    # -O1 runs the tests several times faster than deal.II's -O0 and compiles as
    # fast; -g1 keeps functions and lines of a report. Fortified C functions
    # would hide their arguments from the sanitizer.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=undefined
      -fno-omit-frame-pointer -O1 -g1 -U_FORTIFY_SOURCE)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# asperity_precompile(target room): where a room rests on deal.II, its headers take
# half of the time of a compilation and are parsed once for all.
set(rooms_on_deal_ii splines isogeometric solvers solid contact heat postprocess
  flow lubricant mesh_motion coupling contact_zone fluid_structure campaign learned_fields
  learned_shapes tool_design)
function(asperity_precompile target room)
  if(NOT ASPERITY_PRECOMPILE_HEADERS OR NOT room IN_LIST rooms_on_deal_ii)
    return()
  elseif(target STREQUAL asperity_splines)
    target_precompile_headers(${target} PRIVATE ${CMAKE_SOURCE_DIR}/cmake/precompiled.h)
  else()
    target_precompile_headers(${target} REUSE_FROM asperity_splines)
  endif()
endfunction()

# asperity_room(name [rooms it may include ...]): source/<name>/*.cc as a library.
function(asperity_room name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/source/${name}/*.cc)
  list(TRANSFORM ARGN PREPEND asperity_ OUTPUT_VARIABLE rooms)
  if(sources)
    add_library(asperity_${name} STATIC ${sources})
    asperity_flags(asperity_${name})
    asperity_precompile(asperity_${name} ${name})
    target_link_libraries(asperity_${name} ${rooms})
    if(name STREQUAL "topography")
      target_link_libraries(asperity_${name} PkgConfig::MINIZIP GSL::gsl)
    elseif(name STREQUAL "solvers")
      target_link_libraries(asperity_${name} ${KLU_LIBRARY} ${UMFPACK_LIBRARY} ${CHOLMOD_LIBRARY}
        ${DMUMPS_LIBRARY})
    elseif(name STREQUAL "surrogate")
      target_link_libraries(asperity_${name} LAPACK::LAPACK GSL::gsl)
    elseif(name STREQUAL "learning")
      target_link_libraries(asperity_${name} LAPACK::LAPACK)
    elseif(name STREQUAL "optimization")
      target_link_libraries(asperity_${name} PkgConfig::NLOPT)
    endif()
  else()
    add_library(asperity_${name} INTERFACE)
    target_link_libraries(asperity_${name} INTERFACE ${rooms})
  endif()
endfunction()

# The inner loops of the Gaussian process become vector instructions only if sums
# may be reordered and no one looks at errno; nothing else is compiled like this.
# Sanitizers would keep them scalar, so that their last digits differ from those of
# the friction library, which is never sanitized: this file is not, either.
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/surrogate/correlation.cc
  PROPERTIES COMPILE_OPTIONS "-O3;-ffast-math;-ffp-contract=fast;-fno-sanitize=all")

# So do the functions of neurons.
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/learning/activation.cc
  PROPERTIES COMPILE_OPTIONS "-O3;-ffast-math;-ffp-contract=fast;-fno-sanitize=all" SKIP_UNITY_BUILD_INCLUSION ON)

# Vector instructions for the inner loops of the solid, of its material laws, and
# of the solver: sums keep their order.
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/solid/element_stiffness.cc
  ${CMAKE_SOURCE_DIR}/source/solid/element_gradients.cc
  ${CMAKE_SOURCE_DIR}/source/solvers/supernodal_panels.cc
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=fast")
set_source_files_properties(${CMAKE_SOURCE_DIR}/source/constitutive/johnson_cook.cc
  ${CMAKE_SOURCE_DIR}/source/constitutive/voce.cc
  ${CMAKE_SOURCE_DIR}/source/constitutive/hencky_elasticity.cc
  PROPERTIES COMPILE_OPTIONS "-ffp-contract=fast;-fno-math-errno")

# Sources that are not compiled together with others of their room: parts of a
# class that all end with its explicit instantiation, problems that number
# their boundaries each in its own way, and those through which others of their room
# would link the program asperity, which starts at once, to deal.II and MPI.
set(apart base/archive base/commented_parameters base/input_record base/mpi_session
  base/parameter_file base/parameter_kinds base/parameter_output base/parameters base/ranks
  experiment/conditions_command experiment/experiment_parameters
  contact/contact_state contact/shear_results contact_zone/sliding_run_interface
  contact_zone/sliding_run_results fluid_structure/enclosed_domain
  fluid_structure/inflatable_box fluid_structure/lined_channel learned_shapes/commands
  learned_shapes/shape_study learned_shapes/shape_tables learning/training)
list(TRANSFORM apart PREPEND ${CMAKE_SOURCE_DIR}/source/)
list(TRANSFORM apart APPEND .cc)
set_source_files_properties(${apart} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
