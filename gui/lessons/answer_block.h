#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace unprojector::gui {

class LessonPlayer;

/// The question of a lesson's step, the field for its answer and the verdict. The verdict has
/// reserved space, so that nothing moves when it appears; a long one scrolls.
class AnswerBlock : public QWidget {
    Q_OBJECT
public:
    /// @param player  outlives the block
    explicit AnswerBlock(LessonPlayer &player, QWidget *parent = nullptr);

    /// Shows the question of the player's step, without an answer. Hidden if the step asks nothing.
    void showQuestion();
    /// The question as plain text.
    QString question() const;

private:
    void check();
    void reveal();
    void say(const QString &verdict);

    LessonPlayer &m_player;
    QLabel *m_question;
    QLineEdit *m_answer;
    QPushButton *m_check;
    QPushButton *m_reveal;
    QLabel *m_verdict;
};

} // namespace unprojector::gui
