#pragma once

#include <QString>
#include <QWidget>

namespace unprojector::gui {

/// A figure of the help, as wide as the available room, up to its own size.
class FigureView : public QWidget {
    Q_OBJECT
public:
    /// @param name  see helpFigureNames
    explicit FigureView(const QString &name, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_name;
};

} // namespace unprojector::gui
