# Compiler settings that every target shares.
find_program(CCACHE ccache)
if(CCACHE)
    # With precompiled headers it needs to be told that what they define is not looked at.
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE}")
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -fdiagnostics-color=always)
# The same expression must give the same bits in every translation unit: no contraction into fused operations.
add_compile_options(-ffp-contract=off)

if(CSGSCOPE_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    add_link_options(-fsanitize=address,undefined)
endif()

if(CSGSCOPE_FUZZ_SANITIZE AND CSGSCOPE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    add_link_options(-fsanitize=address,undefined)
elseif(CSGSCOPE_FUZZ)
    # Comparisons are not traced: with geometry that takes half of the time and finds nothing.
    add_compile_options(-fsanitize-coverage=inline-8bit-counters,pc-table -fno-omit-frame-pointer)
endif()
