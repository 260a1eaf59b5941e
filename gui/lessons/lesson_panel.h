#pragma once

#include "core/lessons/link.h"

#include <QSize>
#include <QString>
#include <QWidget>

#include <string>

class QComboBox;
class QLabel;
class QPushButton;
class QTextBrowser;
class QToolButton;

namespace unprojector::gui {

class AnswerBlock;
class LessonPlayer;
class SceneDocument;

/// The present step of a lesson: its text with links that act on the scene, its question, and the
/// navigation. After the last step: the results, and a link to the next lesson. About 340 logical
/// pixels wide; a text taller than the panel scrolls, and the widgets below it stay in place.
class LessonPanel : public QWidget {
    Q_OBJECT
public:
    /// @param player, document  outlive the panel
    LessonPanel(LessonPlayer &player, SceneDocument &document, QWidget *parent = nullptr);

    /// Gives the panel a close button of its own, for a frame without one. At first it has none.
    void setClosesItself(bool does);
    /// Title, step, text, source and question as plain text.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the panel's own close button was pressed.
    void closeRequested();
    /// Emitted when the lesson is over, and its scene must be left.
    void finished();
    void lessonRequested(const std::string &name);
    /// Emitted when the user follows a link that leads out of the panel.
    void linkFollowed(const unprojector::lessons::Link &link);

protected:
    void changeEvent(QEvent *event) override;

private:
    void showStep();
    void showText();
    void showHint();
    void showWayOn();
    void follow(const QString &link);
    void goOn();
    void goBack();
    void setAtEnd(bool isAtEnd);

    LessonPlayer &m_player;
    SceneDocument &m_document;
    QLabel *m_title;
    QToolButton *m_close;
    QComboBox *m_steps;
    QTextBrowser *m_text;
    QLabel *m_hint; ///< tells that the scene or the view differs from the step's
    AnswerBlock *m_asking;
    QPushButton *m_back;
    QPushButton *m_leave; ///< at the end
    QPushButton *m_next;
    bool m_isAtEnd = false; ///< after the last step
};

} // namespace unprojector::gui
