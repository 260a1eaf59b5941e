#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace unprojector::gui {

class LessonPlayer;

/// The question of a lesson's step, the field for its answer and the verdict. The verdict has room of its own, so that nothing moves
/// when it is shown; a long one scrolls.
class AnswerBlock : public QWidget {
    Q_OBJECT
public:
    /// @param player  outlives the block
    explicit AnswerBlock(LessonPlayer &player, QWidget *parent = nullptr);

    /// Shows the question of the player's step, without an answer. Hidden where the step asks nothing.
    void showQuestion();
    /// Plain.
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
