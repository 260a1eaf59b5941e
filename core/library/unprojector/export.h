#pragma once

/// UNPROJECTOR_PUBLIC marks what the shared library exports. Programs that link these sources
/// statically define UNPROJECTOR_STATIC.
#if defined(UNPROJECTOR_STATIC)
#define UNPROJECTOR_PUBLIC
#elif defined(_WIN32)
#if defined(UNPROJECTOR_BUILDING_LIBRARY)
#define UNPROJECTOR_PUBLIC __declspec(dllexport)
#else
#define UNPROJECTOR_PUBLIC __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define UNPROJECTOR_PUBLIC [[gnu::visibility("default")]]
#else
#define UNPROJECTOR_PUBLIC
#endif
