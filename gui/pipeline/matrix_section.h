#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class FactorsView;
class HelpLink;
class MatrixModel;
class NumberGrid;

/// A matrix under its name, with a copy menu.
class MatrixSection : public QWidget {
    Q_OBJECT
public:
    explicit MatrixSection(MatrixModel *model, QWidget *parent = nullptr);

    /// @param title    "View: world → eye"
    /// @param name     the short form: "View"
    /// @param product  the factors of a product, else empty
    void setTitle(const QString &title, const QString &name, const QString &product);
    /// Sets the matrix's anchor in the help; without it the heading has no link.
    void setHelp(const QString &anchor);

    /// Inserts a widget directly below the numbers.
    void putBelowNumbers(QWidget *widget);

    /// Adds a button that decomposes the matrix, and below the matrix its factors, folded at first.
    FactorsView *addFactors();
    /// Shows the factors, or hides them. @pre addFactors()
    void setApart(bool isApart);
    bool isApart() const;
    /// Returns whether the factors are visible whenever the section is; only then they must be kept
    /// up to date.
    bool showsFactors() const;

signals:
    void factorsOpened();
    /// Emitted when a number becomes the current one.
    /// @param mathRow  its row in the matrix for column vectors
    void rowChosen(int mathRow);

private:
    MatrixModel *m_model;
    QLabel *m_heading;
    NumberGrid *m_grid;
    QToolButton *m_copy;
    HelpLink *m_help;
    QLabel *m_product;
    QToolButton *m_takeApart = nullptr;
    FactorsView *m_factors = nullptr;
};

} // namespace unprojector::gui
