#pragma once

#include "core/lessons/link.h"

#include <QSize>
#include <QString>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QTextBrowser;
class QToolButton;
class QPushButton;

namespace unprojector::gui {

class LessonPlayer;
class SceneDocument;

/// The step of the lesson that is shown: its text, whose links do what it speaks of, what it asks, and the way on. About 340
/// logical pixels wide; the text scrolls where it is taller than the panel.
class LessonPanel : public QWidget {
    Q_OBJECT
public:
    /// @param player, document  outlive the panel
    LessonPanel(LessonPlayer &player, SceneDocument &document, QWidget *parent = nullptr);

    /// Where the frame around the panel has no button that closes it, the panel has one. At first it has none.
    void setClosesItself(bool does);
    /// Title, step, text and source, plain.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Its own button was pressed.
    void closeRequested();
    /// A link that leads out of the panel was followed.
    void linkFollowed(const unprojector::lessons::Link &link);

protected:
    void changeEvent(QEvent *event) override;

private:
    void showStep();
    void showText();
    void showHint();
    void follow(const QString &link);
    void check();
    void reveal();
    void showAnswer();

    LessonPlayer &m_player;
    SceneDocument &m_document;
    QLabel *m_title;
    QToolButton *m_close;
    QComboBox *m_steps;
    QTextBrowser *m_text;
    QLabel *m_hint; ///< where the scene or the view is not the step's
    QWidget *m_asking;
    QLineEdit *m_answer;
    QPushButton *m_check;
    QPushButton *m_reveal;
    QLabel *m_verdict;
    QPushButton *m_back;
    QPushButton *m_next;
    QLabel *m_source;
};

} // namespace unprojector::gui
