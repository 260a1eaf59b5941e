#pragma once

#include <QFrame>

class QLabel;

namespace unprojector::gui {

class SceneDocument;

/// Returns whether the viewport stretches the scene although another viewport would not.
bool isPictureStretched(const SceneDocument &document);
/// Gives the viewport the projection's aspect, as large as the window allows.
void letterbox(SceneDocument &document);

/// A bar over the view that reports different aspects of projection and viewport, and offers a
/// viewport that fits. It disappears when the aspects fit. Once closed, it stays hidden until they
/// have fitted or another scene is opened.
class StretchBar : public QFrame {
    Q_OBJECT
public:
    /// @param document  outlives the bar
    explicit StretchBar(SceneDocument &document, QWidget *parent = nullptr);

    /// Hides the bar in lessons, which stretch the view on purpose and explain it themselves.
    void setInLesson(bool isInLesson);

private:
    void refresh();

    SceneDocument &m_document;
    QLabel *m_text;
    bool m_isInLesson = false;
    bool m_isClosed = false;
};

} // namespace unprojector::gui
