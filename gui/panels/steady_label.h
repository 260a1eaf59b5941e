#pragma once

#include <QLabel>
#include <QStringList>

namespace unprojector::gui {

/// A text over several lines with room for the longest that it will ever say: it is as high at every width as that needs,
/// whatever it says now, so that nothing around it moves. Texts can be selected; the tooltip of a text that is longer after
/// all has the whole of it.
class SteadyLabel : public QLabel {
    Q_OBJECT
public:
    /// @param longest  the texts to keep room for
    explicit SteadyLabel(const QStringList &longest, QWidget *parent = nullptr);

    /// Lines that the longest text needs at a width.
    int heightAt(int width) const;

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void keepRoom();

    QStringList m_longest;
};

} // namespace unprojector::gui
