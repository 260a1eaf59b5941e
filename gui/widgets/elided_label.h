#pragma once

#include <QLabel>

namespace unprojector::gui {

/// A line of text that ends in "…" if there is no room for all of it; the tooltip then shows all.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    const QString &fullText() const { return m_fullText; }
    void setFullText(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void elide();

    QString m_fullText;
};

} // namespace unprojector::gui
