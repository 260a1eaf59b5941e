#pragma once

#include <QStringList>
#include <QWidget>

class QButtonGroup;

namespace unprojector::gui {

/// A few choices side by side, one of which is selected. The arrow keys move between them.
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
    /// Emitted when the user or setChoice selects a choice.
    void chosen(int index);

private:
    QButtonGroup *m_group;
};

} // namespace unprojector::gui
