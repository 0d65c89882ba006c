#pragma once

namespace pcl::acmap::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ACMAP_IS_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ACMAP_IS_SANITIZED
#endif

/** \brief Is the program built with AddressSanitizer or ThreadSanitizer? They need
 * several times the memory, and end the process if memory is exhausted. */
#ifdef ACMAP_IS_SANITIZED
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

#undef ACMAP_IS_SANITIZED

} // namespace pcl::acmap::test
