#pragma once

#include "gui/view/lifecycle_event.h"

#include <QAbstractItemModel>
#include <QElapsedTimer>

#include <deque>

namespace unprojector::gui {

/// The steps of a view's life, in order. A frame that repeats the steps of the one before it
/// (OnDraw alone, or OnDraw after the same parameters) is folded into these rows; a folded row has
/// the single steps as its children.
class LifecycleLog : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { Time, Step, StandsFor, Took, ColumnCount };
    /// The largest number of rows; the oldest are dropped.
    static constexpr int kMostRows = 2000;
    /// The number of newest steps that a folded row keeps.
    static constexpr int kMostRepeats = 200;

    explicit LifecycleLog(QObject *parent = nullptr);

    void append(const LifecycleEvent &event);
    /// Clears the log. Its clock runs on.
    void clear();

    /// The rows from `first` to `last`, one a line, tab-separated.
    QString text(int first, int last) const;
    /// A row, or a step of a folded one.
    QString text(const QModelIndex &index) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Happened {
        LifecycleEvent event;
        double seconds = 0.0;
    };
    struct Row {
        const LifecycleEvent &event() const { return steps.back().event; }

        std::deque<Happened> steps; ///< at least one; the newest last
        double firstSeconds = 0.0;
        int count = 1;
        int standIns = 0; ///< number of these frames with coarse models
        double totalMilliseconds = 0.0;
    };
    /// The row of an index, or the row that its step is folded into.
    const Row &rowOf(const QModelIndex &index) const;
    QString stepText(const QModelIndex &index) const;
    QString callsText(const QModelIndex &index) const;
    QString toolTip(const QModelIndex &index) const;
    /// Folds the last frame into the one before it, if it repeats that one's steps.
    void fold();
    void foldInto(int row, const Happened &step);

    QElapsedTimer m_clock; ///< since the first step
    std::deque<Row> m_rows;
    quintptr m_gone = 0; ///< dropped rows: a step's index holds its row number, counted from the first row ever
};

} // namespace unprojector::gui
