# csgscope_embed_shaders(TARGET NAMESPACE): embeds every shader file of the current folder and those below it (*.vert,
# *.frag, *.comp, *.glsl) into TARGET, as `std::span<const gl::ShaderFile> NAMESPACE::shader_files()`, declared in
# gl/shader_file.h's form by the folder's own header.
function(csgscope_embed_shaders target namespace)
    file(GLOB_RECURSE shaders CONFIGURE_DEPENDS
        "${CMAKE_CURRENT_SOURCE_DIR}/*.vert" "${CMAKE_CURRENT_SOURCE_DIR}/*.frag"
        "${CMAKE_CURRENT_SOURCE_DIR}/*.comp" "${CMAKE_CURRENT_SOURCE_DIR}/*.glsl")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}_shader_files.cpp")
    add_custom_command(OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}" "-DSHADERS=${shaders}"
                "-DROOT=${PROJECT_SOURCE_DIR}" -P "${PROJECT_SOURCE_DIR}/cmake/write_shader_files.cmake"
        DEPENDS ${shaders} "${PROJECT_SOURCE_DIR}/cmake/write_shader_files.cmake"
        VERBATIM)
    set_source_files_properties("${output}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE "${output}")
endfunction()
