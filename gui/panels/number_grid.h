#pragma once

#include <QTableView>

namespace unprojector::gui {

class NumberGridModel;

/// Numbers under each other in columns of equal width, as a matrix is printed, with brackets if wanted. It is as high
/// as its rows. Arrow keys walk through the numbers, Copy takes the selected ones with all their digits.
class NumberGrid : public QTableView {
    Q_OBJECT
public:
    enum class Frame { None, Brackets };

    NumberGrid(NumberGridModel *model, Frame frame, QWidget *parent = nullptr);

    /// The selected numbers with all digits, a row a line, tab-separated.
    QString selectedText() const;

    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void useFont();
    void fitHeight();
    void fitColumns();

    NumberGridModel *m_model;
    Frame m_frame;
};

} // namespace unprojector::gui
