#pragma once

#include <QStringList>
#include <QWidget>

class QButtonGroup;

namespace unprojector::gui {

/// A few choices side by side, one of which is taken. The arrow keys move between them.
class SegmentedSwitch : public QWidget {
    Q_OBJECT
public:
    struct Choice {
        QString text;
        QString toolTip;
    };
    SegmentedSwitch(const QString &accessibleName, const QList<Choice> &choices, QWidget *parent = nullptr);

    int choice() const;
    void setChoice(int index);
    void setChoiceEnabled(int index, bool isEnabled);

signals:
    /// By the user or by setChoice.
    void chosen(int index);

private:
    QButtonGroup *m_group;
};

} // namespace unprojector::gui
