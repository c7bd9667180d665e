#pragma once

/// IECFRONT_API marks what the library exports. Everything else is hidden in a shared build.
/// The build defines IECFRONT_SHARED for the library and its users, IECFRONT_BUILDING for the
/// library alone.
#if !defined(IECFRONT_SHARED)
#define IECFRONT_API
#elif defined(_WIN32) && defined(IECFRONT_BUILDING)
#define IECFRONT_API __declspec(dllexport)
#elif defined(_WIN32)
#define IECFRONT_API __declspec(dllimport)
#else
#define IECFRONT_API __attribute__((visibility("default")))
#endif
