# csgscope_library(NAME [libraries...]): one folder, one static library. Sources are all .cpp files of the folder and
# those below it.
function(csgscope_library name)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    if(NOT sources)
        return()
    endif()
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} PUBLIC ${ARGN})
    csgscope_parse_once(${name})
    csgscope_batches(${name})
endfunction()
