#pragma once

#include <QFrame>

class QLabel;

namespace unprojector::gui {

class SceneDocument;

/// Whether the viewport stretches the picture although another one would not.
bool isPictureStretched(const SceneDocument &document);
/// Gives the viewport the projection's aspect, as large as the window allows.
void letterbox(SceneDocument &document);

/// Tells over the view that a projection and its viewport have two aspects, and offers the viewport that fits. It goes where the
/// aspects fit, and stays away once it is closed, until they have fitted or another scene is opened.
class StretchBar : public QFrame {
    Q_OBJECT
public:
    /// @param document  outlives the bar
    explicit StretchBar(SceneDocument &document, QWidget *parent = nullptr);

    /// Lessons stretch pictures to show it, and say so themselves.
    void setInLesson(bool isInLesson);

private:
    void refresh();

    SceneDocument &m_document;
    QLabel *m_text;
    bool m_isInLesson = false;
    bool m_isClosed = false;
};

} // namespace unprojector::gui
