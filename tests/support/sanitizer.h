// What tests of time and memory must know of how they are built.
#pragma once

namespace test_support {

/// Built with the address sanitizer? It takes several times as long and as much stack. Its shadow counts as memory of
/// the process, and where there is no more it ends that: with any limit of memory no program does more than begin.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitizer = false;
#endif

}  // namespace test_support
