#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class FactorsView;
class HelpLink;
class MatrixModel;

/// A matrix under a heading that opens and closes it, with a menu that copies it.
class MatrixSection : public QWidget {
    Q_OBJECT
public:
    explicit MatrixSection(MatrixModel *model, QWidget *parent = nullptr);

    /// "View", "eyeFromWorld", and for a product its factors.
    void setTitle(const QString &name, const QString &variable, const QString &product);
    bool isOpen() const { return m_isOpen; }
    void setOpen(bool isOpen);
    /// Where Help has the matrix; without it the heading has no link.
    void setHelp(const QString &anchor);

    /// Adds a button that takes the matrix apart, and below the matrix its factors, folded at first.
    FactorsView *addFactors();
    /// Shows the factors. @pre addFactors()
    void takeApart();
    /// Whether the factors are to be seen; only then they need be kept up to date.
    bool showsFactors() const;

signals:
    void factorsOpened();

private:
    MatrixModel *m_model;
    QToolButton *m_heading;
    QToolButton *m_copy;
    HelpLink *m_help;
    QLabel *m_product;
    QWidget *m_body;
    QToolButton *m_takeApart = nullptr;
    FactorsView *m_factors = nullptr;
    bool m_isOpen = false;
};

} // namespace unprojector::gui
