#pragma once

// The Windows header without its harmful additions: macros named min and max, sockets, OLE. Include
// it only on Windows.

#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>
