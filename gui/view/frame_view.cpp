#include "gui/view/frame_view.h"

#include <QEvent>
#include <QOpenGLContext>
#include <QScopedValueRollback>
#include <QSurfaceFormat>

namespace unprojector::gui {
namespace {

/// A frame that has not been drawn anew for so long is at rest.
constexpr int kRestMilliseconds = 120;

/// Behind the objects, at the bottom and at the top: light or dark as the window is.
std::array<QColor, 2> backgroundOf(const QPalette &palette)
{
    const bool isDark = palette.color(QPalette::Window).lightnessF() < 0.5F;
    return isDark ? std::array{QColor(0x25, 0x27, 0x2a), QColor(0x36, 0x39, 0x3e)}
                  : std::array{QColor(0xd4, 0xd9, 0xde), QColor(0xf2, 0xf5, 0xf7)};
}

} // namespace

QSurfaceFormat FrameView::preCreateWindow()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);
    return format;
}

FrameView::FrameView(QWidget *parent) : QOpenGLWidget(parent)
{
    setFormat(preCreateWindow());
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    m_restTimer.setSingleShot(true);
    connect(&m_restTimer, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

void FrameView::setSmoothEdges(bool smooth)
{
    m_smoothEdges = smooth;
    update();
}

bool FrameView::createFrame()
{
    initializeOpenGLFunctions();
    const QSurfaceFormat actual = context()->format();
    if (actual.version() < qMakePair(3, 3)) {
        emit failed(tr("OpenGL %1.%2 is too old: the view needs 3.3. Update the graphics driver.")
                        .arg(actual.majorVersion())
                        .arg(actual.minorVersion()));
        return false;
    }
    const auto text = [this](GLenum name) {
        return QString::fromLatin1(reinterpret_cast<const char *>(glGetString(name)));
    };
    m_openGLName = QStringLiteral("%1, %2").arg(text(GL_VERSION), text(GL_RENDERER));
    m_frame.initialize();
    m_background.initialize();
    m_meshes.initialize(m_frame.ids());
    m_painter.initialize();
    m_isCreated = true;
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &FrameView::releaseGL, Qt::UniqueConnection);
    return true;
}

void FrameView::releaseFrame()
{
    m_frame.release();
    m_background.release();
    m_meshes.release();
    m_painter.release();
    m_isCreated = false;
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &FrameView::releaseGL);
}

bool FrameView::drawFrame(const Drawable &drawn, const std::vector<SceneObject> &objects,
                          const glm::dmat4 &clipFromWorld, const glm::dmat4 &eyeFromWorld,
                          const std::vector<glm::dvec4> &clipPlanes)
{
    m_painter.setStale();
    m_sinceDrawn.start();
    if (!m_frame.begin(drawn)) {
        const Surface &surface = drawn.picture.surface;
        emit failed(tr("OpenGL draws no picture of %1 × %2 pixels. Make the window smaller, or update the graphics "
                       "driver.")
                        .arg(surface.widthPixels)
                        .arg(surface.heightPixels));
        return false;
    }
    m_background.draw(backgroundOf(palette()));
    m_frame.beginObjects();
    m_meshes.draw(objects, clipFromWorld, eyeFromWorld, clipPlanes);
    m_frame.end();
    for (const QString &failure : m_meshes.takeFailures())
        emit failed(failure);
    return true;
}

bool FrameView::showFrame()
{
    if (!m_frame.picture()) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); // why has been told
        return false;
    }
    const bool isInMotion = m_isOnScreen && m_painter.isSmoothingSlow() && !m_sinceDrawn.hasExpired(kRestMilliseconds);
    const Surface &surface = m_frame.picture()->surface;
    m_painter.draw({m_frame.colors(), m_frame.depths(), surface.widthPixels, surface.heightPixels},
                   m_smoothEdges && !isInMotion);
    if (m_smoothEdges && isInMotion)
        m_restTimer.start(kRestMilliseconds);
    return true;
}

Surface FrameView::currentSurface() const
{
    return surfaceFromWidget(width(), height(), devicePixelRatio());
}

void FrameView::paintEvent(QPaintEvent *event)
{
    // A view that has been resized is painted by QOpenGLWidget at once, and then again with the window: once is enough,
    // and what has not been laid out to its end, as a window that opens, is not painted at every step of it.
    if (m_isResizing)
        return;
    const QScopedValueRollback onScreen(m_isOnScreen, true);
    QOpenGLWidget::paintEvent(event);
}

void FrameView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange) {
        m_isStale = true;
        update();
    }
    QOpenGLWidget::changeEvent(event);
}

void FrameView::resizeEvent(QResizeEvent *event)
{
    const QScopedValueRollback resizing(m_isResizing, true);
    QOpenGLWidget::resizeEvent(event);
}

} // namespace unprojector::gui
