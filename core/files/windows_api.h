#pragma once

// Windows' own header without what it adds that hurts: macros named min and max, sockets, OLE. Included only where the
// system is Windows.

#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>
