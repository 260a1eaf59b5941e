#pragma once

#include "gui/panels/copy_menu.h"

#include <QLabel>
#include <QStringList>

#include <utility>

namespace unprojector::gui {

/// A text over several lines with room for the longest that it will ever say: it is as high at every width as that needs,
/// whatever it says now, so that nothing around it moves. Texts can be selected; the tooltip of a text that is longer after
/// all has the whole of it.
class SteadyLabel : public QLabel {
    Q_OBJECT
public:
    /// @param longest  the texts to keep room for
    explicit SteadyLabel(const QStringList &longest, QWidget *parent = nullptr);

    /// What its menu copies besides the text.
    void setValue(Copyable value) { m_value = std::move(value); }

    /// Lines that the longest text needs at a width.
    int heightAt(int width) const;

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void keepRoom();

    QStringList m_longest;
    Copyable m_value;
};

} // namespace unprojector::gui
