#pragma once

namespace unprojector::scene_code {

/// The handlers that the paper rewrites (section 4), around the functions of the GLU code; the same
/// for every scene.
inline constexpr const char *kMfcHandlers = R"(
#ifdef __AFXWIN_H__ // after <afxwin.h>: the view of an MFC program. Link opengl32.lib and glu32.lib.

class SceneView : public CView {
    DECLARE_DYNCREATE(SceneView)

protected:
    BOOL PreCreateWindow(CREATESTRUCT &cs) override;
    void OnDraw(CDC *dc) override;
    afx_msg int OnCreate(LPCREATESTRUCT cs);
    afx_msg void OnSize(UINT type, int cx, int cy);
    afx_msg BOOL OnEraseBkgnd(CDC *dc);
    afx_msg void OnLButtonDown(UINT flags, CPoint point);
    afx_msg void OnDestroy();
    DECLARE_MESSAGE_MAP()

private:
    HDC m_dc = nullptr;
    HGLRC m_rc = nullptr;
};

IMPLEMENT_DYNCREATE(SceneView, CView)

BEGIN_MESSAGE_MAP(SceneView, CView)
    ON_WM_CREATE()
    ON_WM_SIZE()
    ON_WM_ERASEBKGND()
    ON_WM_LBUTTONDOWN()
    ON_WM_DESTROY()
END_MESSAGE_MAP()

BOOL SceneView::PreCreateWindow(CREATESTRUCT &cs)
{
    cs.style = WS_CHILD | WS_VISIBLE | WS_CLIPCHILDREN | WS_CLIPSIBLINGS;
    cs.lpszClass = AfxRegisterWndClass(CS_OWNDC | CS_HREDRAW | CS_VREDRAW, ::LoadCursor(nullptr, IDC_ARROW));
    return CView::PreCreateWindow(cs);
}

int SceneView::OnCreate(LPCREATESTRUCT cs)
{
    if (CView::OnCreate(cs) == -1)
        return -1;
    PIXELFORMATDESCRIPTOR format = {};
    format.nSize = sizeof(format);
    format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    format.iPixelType = PFD_TYPE_RGBA;
    format.cColorBits = 24;
    format.cDepthBits = 24;
    m_dc = ::GetDC(m_hWnd);
    const int number = ::ChoosePixelFormat(m_dc, &format);
    if (number == 0 || !::SetPixelFormat(m_dc, number, &format))
        return -1;
    m_rc = ::wglCreateContext(m_dc);
    if (m_rc == nullptr || !::wglMakeCurrent(m_dc, m_rc))
        return -1;
    setUp();
    return 0;
}

void SceneView::OnSize(UINT type, int cx, int cy)
{
    CView::OnSize(type, cx, cy);
    if (m_rc == nullptr || cx <= 0 || cy <= 0)
        return;
    windowWidth = cx;
    windowHeight = cy;
    ::wglMakeCurrent(m_dc, m_rc);
    setViewport();
    setProjection();
}

void SceneView::OnDraw(CDC *)
{
    ::wglMakeCurrent(m_dc, m_rc);
    drawScene();
    ::SwapBuffers(m_dc);
}

BOOL SceneView::OnEraseBkgnd(CDC *)
{
    return TRUE; // OpenGL paints all of it
}

void SceneView::OnLButtonDown(UINT flags, CPoint point)
{
    CView::OnLButtonDown(flags, point);
    ::wglMakeCurrent(m_dc, m_rc);
    drawScene(); // once the buffers are swapped, the depths need not be there any more
    GLdouble world[3];
    CString text(_T("Background: no surface here"));
    if (screen2world(point.x, point.y, world)) // device pixels, where the program is aware of them (its manifest's dpiAware)
        text.Format(_T("%.7g, %.7g, %.7g"), world[0], world[1], world[2]);
    AfxGetMainWnd()->SetWindowText(text);
}

void SceneView::OnDestroy()
{
    ::wglMakeCurrent(nullptr, nullptr);
    if (m_rc != nullptr)
        ::wglDeleteContext(m_rc);
    if (m_dc != nullptr)
        ::ReleaseDC(m_hWnd, m_dc);
    m_rc = nullptr;
    m_dc = nullptr;
    CView::OnDestroy();
}

#endif
)";

} // namespace unprojector::scene_code
