#pragma once

// Stand-ins for the part of Windows and MFC that the handlers of the GLU code use, on the current
// OpenGL context. The handlers are compiled and run where neither exists; on Windows the real ones
// would conflict.
#ifndef _WIN32
#define __AFXWIN_H__

#include <cstdarg>
#include <cstdio>
#include <string>

using BOOL = int;
using UINT = unsigned;
using HDC = void *;
using HGLRC = void *;
using HWND = void *;
constexpr BOOL TRUE = 1;

struct CREATESTRUCT {
    long style = 0;
    const char *lpszClass = nullptr;
};
using LPCREATESTRUCT = CREATESTRUCT *;
struct CPoint {
    long x, y;
};
class CDC {};

constexpr long WS_CHILD = 1, WS_VISIBLE = 2, WS_CLIPCHILDREN = 4, WS_CLIPSIBLINGS = 8;
constexpr int CS_OWNDC = 1, CS_HREDRAW = 2, CS_VREDRAW = 4, IDC_ARROW = 0;
constexpr unsigned PFD_DRAW_TO_WINDOW = 1, PFD_SUPPORT_OPENGL = 2, PFD_DOUBLEBUFFER = 4;
constexpr int PFD_TYPE_RGBA = 0;
struct PIXELFORMATDESCRIPTOR {
    unsigned short nSize, nVersion;
    unsigned dwFlags;
    unsigned char iPixelType, cColorBits, cDepthBits;
};

inline int things[3]; // to point to: a device, a rendering context, a window
inline int swaps = 0;
inline HDC GetDC(HWND)
{
    return &things[0];
}
inline int ReleaseDC(HWND, HDC)
{
    return 1;
}
inline int ChoosePixelFormat(HDC, const PIXELFORMATDESCRIPTOR *asked)
{
    return asked->nSize == sizeof(PIXELFORMATDESCRIPTOR) && asked->nVersion == 1 ? 7 : 0;
}
inline BOOL SetPixelFormat(HDC, int format, const PIXELFORMATDESCRIPTOR *)
{
    return format == 7;
}
inline HGLRC wglCreateContext(HDC)
{
    return &things[1];
}
inline BOOL wglMakeCurrent(HDC, HGLRC)
{
    return TRUE;
}
inline BOOL wglDeleteContext(HGLRC)
{
    return TRUE;
}
inline BOOL SwapBuffers(HDC)
{
    ++swaps;
    return TRUE;
}
inline void *LoadCursor(void *, int)
{
    return nullptr;
}
inline const char *AfxRegisterWndClass(int, void *)
{
    return "class";
}

class CString {
public:
    explicit CString(const char *text = "") : m_text(text) {}
    void Format(const char *format, ...)
    {
        char text[256];
        va_list values;
        va_start(values, format);
        std::vsnprintf(text, sizeof text, format, values);
        va_end(values);
        m_text = text;
    }
    const std::string &text() const { return m_text; }

private:
    std::string m_text;
};

struct CWnd {
    CString title;
    void SetWindowText(const CString &text) { title = text; }
};
inline CWnd mainWindow;
inline CWnd *AfxGetMainWnd()
{
    return &mainWindow;
}

class CView {
public:
    virtual ~CView() = default;

protected:
    virtual BOOL PreCreateWindow(CREATESTRUCT &) { return TRUE; }
    virtual void OnDraw(CDC *) = 0;
    int OnCreate(LPCREATESTRUCT) { return 0; }
    void OnSize(UINT, int, int) {}
    void OnLButtonDown(UINT, CPoint) {}
    void OnDestroy() {}
    HWND m_hWnd = &things[2];
};

// The message map: like the real one, it requires that its handlers belong to the class.
#define _T(text) text
#define afx_msg
#define DECLARE_DYNCREATE(type)
#define IMPLEMENT_DYNCREATE(type, base)
#define DECLARE_MESSAGE_MAP() static void messageMap();
#define BEGIN_MESSAGE_MAP(type, base)                                                                                  \
    void type::messageMap()                                                                                            \
    {                                                                                                                  \
        using ThisClass = type;
#define END_MESSAGE_MAP() }
#define ON_WM_CREATE() static_cast<void>(&ThisClass::OnCreate);
#define ON_WM_SIZE() static_cast<void>(&ThisClass::OnSize);
#define ON_WM_ERASEBKGND() static_cast<void>(&ThisClass::OnEraseBkgnd);
#define ON_WM_LBUTTONDOWN() static_cast<void>(&ThisClass::OnLButtonDown);
#define ON_WM_DESTROY() static_cast<void>(&ThisClass::OnDestroy);

#endif
