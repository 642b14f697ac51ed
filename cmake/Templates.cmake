# The templates of exported laws become texts of the program. Each compiles as it
# stands, or as a part of tribmu or of friction_law.js; tests do that.
set(templates ${CMAKE_SOURCE_DIR}/source/law_export/templates)
set(law_template_source ${CMAKE_BINARY_DIR}/law_templates.cc)
set(law_template_text "#include \"law_template.h\"\n\nnamespace asperity::law_template\n{\n")
foreach(file ${templates}/tribmu.h ${templates}/tribmu.c ${templates}/tribmu.f ${templates}/tribef.f
    ${templates}/gaussian_process.c ${templates}/gaussian_process.f
    ${templates}/piecewise_power_law.c ${templates}/piecewise_power_law.f
    ${templates}/friction_law.js ${templates}/gaussian_process.js ${templates}/piecewise_power_law.js
    ${templates}/abaqus_fric_coef.f ${templates}/abaqus_vfriction.f ${templates}/deform_usr_bcc.f
    ${CMAKE_SOURCE_DIR}/source/surrogate/kernel_formulas.h)
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} content)
  get_filename_component(name ${file} NAME)
  string(REPLACE "." "_" name ${name})
  string(APPEND law_template_text "  const char *const ${name} = R\"TEMPLATE(${content})TEMPLATE\";\n")
endforeach()
string(APPEND law_template_text "} // namespace asperity::law_template\n")
# written only if it has changed, so that nothing is compiled in vain
file(GENERATE OUTPUT ${law_template_source} CONTENT "${law_template_text}")
target_sources(asperity_law_export PRIVATE ${law_template_source})
target_include_directories(asperity_law_export PRIVATE ${CMAKE_SOURCE_DIR}/source/law_export)
