#pragma once

#include "core/pipeline/matrix_format.h"
#include "gui/widgets/copy_menu.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// Numbers in rows and columns, shown with as many digits as fit and copied with all of them. Texts
/// are made on demand, so that a hidden grid costs nothing.
class NumberGridModel : public QAbstractTableModel {
    Q_OBJECT
public:
    /// The double itself (in float digits: the value rounded to float); invalid if there is no
    /// number.
    static constexpr int kValueRole = Qt::UserRole;
    /// The label before the number: "m[12]".
    static constexpr int kLabelRole = Qt::UserRole + 1;
    /// True if the number is marked.
    static constexpr int kMarkedRole = Qt::UserRole + 2;

    using QAbstractTableModel::QAbstractTableModel;

    /// Sets the characters that a number has room for: longer ones lose digits, not decimal places.
    void setCapacity(int characters);
    /// The least room for each column: a whole double's if all digits are shown, else 0.
    int leastCapacity() const { return m_isWhole ? kWholeDouble : 0; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

    /// Marks only these numbers, until their arrangement changes.
    void setMarked(const QModelIndexList &marked);

    /// The point that a menu copies in addition to a number, or nothing.
    virtual Copyable copyable() const { return {}; }

    /// Returns whether a user can type other numbers, or paste all at once.
    virtual bool isTypable() const { return false; }
    virtual void typeAll([[maybe_unused]] const QString &text) {}

    /// A number with all its digits, "–" if there is none.
    QString fullText(int row, int column) const;

protected:
    using Numbers = std::vector<std::optional<double>>;

    /// Sets the numbers, row by row. The views keep their shape unless the numbers of rows and
    /// columns or `isWhole` change.
    /// @param isWhole  all digits, not only as many as fit
    void setNumbers(int rows, int columns, Numbers numbers, pipeline::Digits digits, bool isWhole);

    virtual QString label(int row, int column) const;
    virtual QString toolTip(int row, int column) const = 0;

private:
    /// "-1.2345678901234567e-300"
    static constexpr int kWholeDouble = 24;

    std::size_t placeOf(int row, int column) const;
    void makeTexts() const;
    const std::optional<double> &number(int row, int column) const;

    int m_rows = 0;
    int m_columns = 0;
    Numbers m_numbers;
    pipeline::Digits m_digits = pipeline::Digits::Double;
    bool m_isWhole = false;
    QModelIndexList m_marked;
    int m_capacity = 12;
    mutable std::vector<QString> m_texts;
    mutable bool m_textsAreStale = true;
};

} // namespace unprojector::gui
