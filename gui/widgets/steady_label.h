#pragma once

#include "gui/widgets/copy_menu.h"

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
    /// @param longest  the texts to keep room for, or their markup
    explicit SteadyLabel(const QStringList &longest, QWidget *parent = nullptr);

    /// Keeps room for others from now on.
    void setLongest(const QStringList &longest);
    /// Shows a text with its indexes set as such. What is copied is the plain text.
    void setMarkup(const QString &markup, const QString &plain);
    /// Shows a text as it is.
    void setPlain(const QString &text);

    /// What its menu copies besides the text.
    void setValue(Copyable value) { m_value = std::move(value); }

    /// Lines that the longest text needs at a width.
    int heightAt(int width) const;

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;
    /// The height is that of the longest text. A label that wraps would lay out each new text several times to tell one.
    bool hasHeightForWidth() const override { return false; }
    int heightForWidth(int) const override { return -1; }

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void keepRoom();

    QStringList m_longest;
    QString m_plain; ///< of the markup
    Copyable m_value;
};

} // namespace unprojector::gui
