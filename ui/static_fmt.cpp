// The functions of {fmt} that are not in its headers, compiled into `csgscope`: the shared library, and the shared
// libstdc++ that it needs, would take longer to load than most models take to evaluate.
#include <fmt/format-inl.h>

template fmt::detail::thousands_sep_result<char> fmt::detail::thousands_sep_impl<char>(fmt::detail::locale_ref);
template char fmt::detail::decimal_point_impl<char>(fmt::detail::locale_ref);
