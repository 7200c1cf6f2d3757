# What most files include is parsed once: precompiled headers, and a few files that include CGAL compiled as one. That
# halves the time of a build from nothing, and changes nothing else: every file includes what it uses, and builds without.
set(CSGSCOPE_PARSE_ONCE_DEFAULT OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(CSGSCOPE_PARSE_ONCE_DEFAULT ON)
endif()
option(CSGSCOPE_PARSE_ONCE "Precompiled headers" ${CSGSCOPE_PARSE_ONCE_DEFAULT})

# For who builds all of it: files of a library are compiled eight at a time, a third of the time of a build from nothing
# again. Who changes files wants them one at a time.
option(CSGSCOPE_BATCHES "Compile eight files at a time" OFF)

if(CSGSCOPE_PARSE_ONCE)
    add_library(csgscope_headers OBJECT "${CMAKE_CURRENT_LIST_DIR}/headers.cpp")
    target_link_libraries(csgscope_headers PRIVATE glm fmt::fmt)
    target_precompile_headers(csgscope_headers PRIVATE "${CMAKE_CURRENT_LIST_DIR}/headers.h")
endif()

# csgscope_parse_once(TARGET [HEADERS]): TARGET, which links {fmt}, gets the headers that are precompiled for all, or
# those of another target that this function was not called for.
function(csgscope_parse_once target)
    if(CSGSCOPE_PARSE_ONCE)
        set(headers csgscope_headers)
        if(ARGC GREATER 1)
            set(headers "${ARGV1}")
        endif()
        target_precompile_headers(${target} REUSE_FROM ${headers})
    endif()
endfunction()

# csgscope_batches(TARGET): with CSGSCOPE_BATCHES, files of TARGET are compiled together. No two of them may then have
# something of the same name in their unnamed namespaces.
function(csgscope_batches target)
    if(CSGSCOPE_BATCHES)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        # So that a program can leave out what it does not refer to. A source that is included looks like a header.
        target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections
            $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endif()
endfunction()

# csgscope_compile_as_one(TARGET SOURCES...): these files of TARGET, and no others, are one for the compiler, in this
# order.
function(csgscope_compile_as_one target)
    if(CSGSCOPE_PARSE_ONCE)
        list(GET ARGN 0 group)
        list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
        set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP "${group}")
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    else()
        set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
    endif()
endfunction()
