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

/// The step of the lesson that is shown: its text, whose links do what it speaks of, what it asks, and the way on; after the last
/// step how the questions were answered, and the way to the next lesson. About 340 logical pixels wide; the text scrolls where
/// it is taller than the panel, and what is below it stays in its place.
class LessonPanel : public QWidget {
    Q_OBJECT
public:
    /// @param player, document  outlive the panel
    LessonPanel(LessonPlayer &player, SceneDocument &document, QWidget *parent = nullptr);

    /// Where the frame around the panel has no button that closes it, the panel has one. At first it has none.
    void setClosesItself(bool does);
    /// Title, step, text, source and question, plain.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Its own button was pressed.
    void closeRequested();
    /// The lesson is over, and its scene is to be left.
    void finished();
    void lessonRequested(const std::string &name);
    /// A link that leads out of the panel was followed.
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
    QLabel *m_hint; ///< where the scene or the view is not the step's
    AnswerBlock *m_asking;
    QPushButton *m_back;
    QPushButton *m_leave; ///< at the end
    QPushButton *m_next;
    bool m_isAtEnd = false; ///< after the last step
};

} // namespace unprojector::gui
