#include "gui/doctor/wrong_points_form.h"

#include "core/doctor/written_points.h"
#include "gui/doctor/step_heading.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/plain_text_box.h"
#include "gui/widgets/refused_field.h"
#include "gui/widgets/typing_pause.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QGridLayout>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace doctor;
namespace {

// Qt's own text in the menu of a field, which Qt translates; in Qt 6.4 the entry has no name.
constexpr const char *kPaste = "&Paste";

constexpr int kHeadRows = 2;

/// A field that offers pasted text to a callback first: it would lose line breaks.
class PasteField : public QLineEdit {
public:
    std::function<bool(const QString &)> takes;

protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        if (event->matches(QKeySequence::Paste) && offers(QClipboard::Clipboard))
            return;
        QLineEdit::keyPressEvent(event);
    }
    void contextMenuEvent(QContextMenuEvent *event) override
    {
        QMenu *menu = createStandardContextMenu();
        menu->setAttribute(Qt::WA_DeleteOnClose);
        for (QAction *action : menu->actions()) {
            if (!action->text().startsWith(QCoreApplication::translate("QLineEdit", kPaste)))
                continue;
            auto *own = new QAction(action->icon(), action->text(), menu);
            own->setEnabled(action->isEnabled());
            connect(own, &QAction::triggered, this, [this] {
                if (!offers(QClipboard::Clipboard))
                    paste();
            });
            menu->insertAction(action, own);
            action->setVisible(false);
        }
        menu->popup(event->globalPos());
    }
    void mouseReleaseEvent(QMouseEvent *event) override
    {
        if (event->button() == Qt::MiddleButton && offers(QClipboard::Selection))
            return;
        QLineEdit::mouseReleaseEvent(event);
    }

private:
    bool offers(QClipboard::Mode mode) const
    {
        const QString text = QGuiApplication::clipboard()->text(mode);
        return !text.isEmpty() && text.size() <= kMostPastedCharacters && takes && takes(text);
    }
};

bool isFilled(const QLineEdit &field)
{
    return !field.text().trimmed().isEmpty();
}

auto numbersOf(const QLineEdit &field, std::size_t count)
{
    return writtenNumbers(field.text().toStdString(), count);
}

/// A depth of a click, as long as a field has room for.
QString clickedText(double depth)
{
    constexpr int kDecimals = 7; // finer than the steps of 24 bits
    return depth == std::floor(depth) ? shortestText(depth) : fixedText(depth, kDecimals);
}

QString quoted(const QLineEdit &field)
{
    return QStringLiteral("“%1”").arg(typedBeginning(field.text().trimmed()));
}

} // namespace

struct WrongPointsForm::Row {
    QLineEdit *pixel = nullptr;
    QLineEdit *depth = nullptr;
    PasteField *got = nullptr;
    QToolButton *remove = nullptr;
    QString clickedPixel; ///< the field's text of the click
    /// The full depth of the click, while the field has its short text.
    std::optional<double> clickedDepth;
    /// The field that was left last, until the next edit.
    QLineEdit *left = nullptr;

    std::array<QLineEdit *, 3> fields() const { return {pixel, depth, got}; }
    bool isEmpty() const { return !isFilled(*pixel) && !isFilled(*depth) && !isFilled(*got); }
    bool isOfClick() const { return isFilled(*pixel) && pixel->text() == clickedPixel; }
    void setClickedDepth(const std::optional<double> &value)
    {
        clickedDepth = value;
        depth->setText(value ? clickedText(*value) : QString());
        depth->setCursorPosition(0);
    }
    /// The depth of a click, with its last shown digit.
    std::optional<WrittenNumber> givenDepth() const
    {
        const auto numbers = numbersOf(*depth, 1);
        if (!numbers)
            return std::nullopt;
        WrittenNumber given = numbers->front();
        if (clickedDepth && depth->text() == clickedText(*clickedDepth))
            given.value = *clickedDepth;
        return given;
    }
    std::optional<WrongPoint> point() const
    {
        const auto position = numbersOf(*pixel, 2), coordinates = numbersOf(*got, 3);
        const auto given = givenDepth();
        if (!position || !coordinates || (isFilled(*depth) && !given))
            return std::nullopt;
        WrongPoint result;
        result.pixel = DevicePoint((*position)[0].value, (*position)[1].value);
        if (given) {
            result.depth = given->value;
            result.depthLastDigit = depthLastDigit(*given);
        }
        for (int axis = 0; axis < 3; ++axis) {
            result.got[axis] = (*coordinates)[std::size_t(axis)].value;
            result.lastDigit[axis] = (*coordinates)[std::size_t(axis)].lastDigit;
        }
        return result;
    }
};

WrongPointsForm::WrongPointsForm(QWidget *parent)
    : QWidget(parent), m_grid(new QGridLayout), m_fault(new QLabel), m_add(new QPushButton(tr("&Another wrong point"))),
      m_pause(new QTimer(this))
{
    m_pause->setSingleShot(true);
    m_pause->setInterval(kTypingPause);
    connect(m_pause, &QTimer::timeout, this, [this] {
        for (const auto &row : m_rows) {
            for (QLineEdit *field : row->fields()) {
                if (field->hasFocus())
                    row->left = field;
            }
        }
        markFaults();
    });
    m_grid->setVerticalSpacing(3);
    m_grid->setHorizontalSpacing(4);
    m_grid->setColumnStretch(0, 9);
    m_grid->setColumnStretch(1, 6);
    m_grid->setColumnStretch(2, 14);
    m_grid->addWidget(stepHeading(2, tr("Your click")), 0, 0, 1, 2);
    m_grid->addWidget(stepHeading(3, tr("What your program printed")), 0, 2, 1, 2);
    const QStringList heads{tr("Pixel x, y"), tr("Depth"), tr("x, y, z")};
    for (int column = 0; column < heads.size(); ++column)
        m_grid->addWidget(new QLabel(heads[column]), 1, column);
    m_fault->setWordWrap(true);
    m_fault->setTextFormat(Qt::PlainText);
    m_fault->setAccessibleName(tr("Reason why the input is rejected"));
    m_fault->hide();
    m_add->setToolTip(
        tr("Add another click of the same program to separate similar mistakes. A click in the view fills it"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(m_grid);
    layout->addWidget(m_fault);
    layout->addWidget(m_add, 0, Qt::AlignLeft);
    connect(m_add, &QPushButton::clicked, this, [this] {
        addRow().pixel->setFocus();
        emit changed();
    });
    addRow();
}

WrongPointsForm::~WrongPointsForm()
{
    // A field that is deleted during editing emits that it was left.
    for (const auto &row : m_rows) {
        for (QLineEdit *field : row->fields())
            field->disconnect(this);
    }
}

WrongPointsForm::Row &WrongPointsForm::addRow()
{
    Row &row = makeRow();
    arrange();
    return row;
}

WrongPointsForm::Row &WrongPointsForm::makeRow()
{
    m_rows.push_back(std::make_unique<Row>());
    Row &row = *m_rows.back();
    row.pixel = new QLineEdit;
    row.pixel->setPlaceholderText(QStringLiteral("400.5, 300.5"));
    row.pixel->setAccessibleName(tr("Pixel"));
    row.pixel->setToolTip(
        tr("Click in the view, or type device pixels from the top-left corner; the first pixel's centre is 0.5, 0.5"));
    row.depth = new QLineEdit;
    row.depth->setPlaceholderText(tr("of mesh"));
    row.depth->setAccessibleName(tr("Depth"));
    row.depth->setToolTip(tr("Correct depth of the pixel, in the view's depth range. Empty: the mesh's depth; without "
                             "a mesh, any depth is possible. A click's depth is used with all digits"));
    row.got = new PasteField;
    row.got->setPlaceholderText(tr("0.7051 -0.4122 0.0918"));
    row.got->setAccessibleName(tr("Your program's coordinate"));
    row.got->setToolTip(
        tr("The wrong coordinate, as the program prints it: 1 2 3, vec3(1, 2, 3), [1. 2. 3.]. Its digits count: 1.50 "
           "has two decimals. Rows of px,py,depth,x,y,z can be pasted"));
    row.remove = new QToolButton;
    row.remove->setText(QStringLiteral("✕"));
    row.remove->setAutoRaise(true);
    row.remove->setToolTip(tr("Remove this point"));
    row.remove->setAccessibleName(row.remove->toolTip());
    Row *const added = &row;
    row.got->takes = [this, added](const QString &text) { return takeTable(*added, text); };
    for (QLineEdit *field : row.fields()) {
        connect(field, &QLineEdit::textEdited, this, [this, added] { edited(*added); });
        connect(field, &QLineEdit::editingFinished, this, [this, added, field] {
            added->left = field;
            markFaults();
        });
    }
    connect(row.remove, &QToolButton::clicked, this, [this, added] { removeRow(added); });
    return row;
}

void WrongPointsForm::removeRow(const Row *row)
{
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [row](const auto &each) { return each.get() == row; });
    for (QWidget *widget : {static_cast<QWidget *>(row->pixel), static_cast<QWidget *>(row->depth),
                            static_cast<QWidget *>(row->got), static_cast<QWidget *>(row->remove)}) {
        widget->disconnect(this);
        widget->hide();
        widget->deleteLater(); // its button may be the sender
    }
    m_rows.erase(found);
    m_beforeClick.reset();
    m_tableFault.clear();
    if (m_rows.empty())
        addRow();
    arrange();
    markFaults();
    emit changed();
}

void WrongPointsForm::arrange()
{
    QWidget *last = nullptr;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = *m_rows[i];
        int column = 0;
        for (QWidget *widget : {static_cast<QWidget *>(row.pixel), static_cast<QWidget *>(row.depth),
                                static_cast<QWidget *>(row.got), static_cast<QWidget *>(row.remove)}) {
            m_grid->addWidget(widget, static_cast<int>(i) + kHeadRows, column++);
            widget->show(); // at once, so that it can get the focus
            if (last)
                setTabOrder(last, widget);
            last = widget;
        }
        // The only row cannot be removed if it is empty; its button keeps its place.
        row.remove->setEnabled(m_rows.size() > 1 || !row.isEmpty());
    }
    if (last)
        setTabOrder(last, m_add);
    m_add->setEnabled(m_rows.size() < kMostWrongPoints);
}

bool WrongPointsForm::takeTable(Row &row, const QString &text)
{
    // A single point belongs into the field.
    if (writtenNumbers(text.toStdString(), 3) || !text.contains(u','))
        return false;
    const Result<std::vector<PointRow>, base::CsvError> rows = pointRows(text.toStdString());
    if (!rows || rows->empty())
        return false;
    for (const PointRow &each : *rows) {
        if (each.isTooLong)
            return false;
    }
    // A single line that is no point stays in the field, which shows the error: 0,5 0,25 1,0.
    if (rows->size() == 1 && !pointOf(rows->front()))
        return false;
    m_beforeClick.reset();
    Row *place = row.isEmpty() ? &row : nullptr;
    QStringList refused;
    std::size_t surplus = 0;
    for (const PointRow &each : *rows) {
        if (!place && m_rows.size() >= kMostWrongPoints) {
            ++surplus;
            continue;
        }
        if (const auto point = pointOf(each); !point) {
            const std::string_view column = kPointColumns[std::min(point.error(), kPointColumns.size() - 1)];
            refused << tr("row %1: %2").arg(each.line).arg(QString::fromUtf8(column.data(), qsizetype(column.size())));
            continue;
        }
        if (!place)
            place = &makeRow();
        const auto cell = [&each](std::size_t column) { return QString::fromStdString(each.cells[column]).trimmed(); };
        place->pixel->setText(cell(0) + QStringLiteral(", ") + cell(1));
        place->clickedDepth.reset();
        place->depth->setText(cell(2));
        place->got->setText(cell(3) + u' ' + cell(4) + u' ' + cell(5));
        place->got->setCursorPosition(0);
        place = nullptr;
    }
    QStringList faults;
    if (!refused.isEmpty())
        faults << tr("Ignored in the pasted text, because it is not a number: %1.")
                      .arg(refused.join(QStringLiteral("; ")));
    if (surplus > 0)
        faults << (surplus == 1 ? tr("The first %1 points are used; %2 more is ignored.")
                                : tr("The first %1 points are used; %2 more are ignored."))
                      .arg(kMostWrongPoints)
                      .arg(surplus);
    m_tableFault = joinSentences(faults);
    arrange();
    markFaults();
    emit changed();
    return true;
}

void WrongPointsForm::edited(Row &row)
{
    row.left = nullptr;
    m_pause->start();
    m_beforeClick.reset();
    m_tableFault.clear();
    arrange();
    markFaults();
    emit changed();
}

std::optional<WrongPointsForm::Fault> WrongPointsForm::faultOf(const Row &row) const
{
    if (isFilled(*row.pixel)) {
        const auto position =
            writtenNumbers(row.pixel->text().toStdString(), 2, tr("its x and y, such as 400.5, 300.5").toStdString());
        if (!position)
            return Fault{
                row.pixel,
                tr("%1 is not a pixel: %2", "the field's text, why").arg(quoted(*row.pixel), ended(position.error()))};
        const double x = (*position)[0].value, y = (*position)[1].value;
        if (m_setup
            && !(x >= 0.0 && y >= 0.0 && x <= m_setup->surface.widthPixels && y <= m_setup->surface.heightPixels))
            return Fault{row.pixel, tr("Pixel %1 lies outside the view of %2 × %3.")
                                        .arg(row.pixel->text().trimmed())
                                        .arg(m_setup->surface.widthPixels)
                                        .arg(m_setup->surface.heightPixels)};
    }
    if (isFilled(*row.depth)) {
        const auto depth = row.givenDepth();
        if (!depth)
            return Fault{row.depth,
                         tr("%1 is not a depth: type one number, or leave it empty.").arg(quoted(*row.depth))};
        if (m_setup && !unitDepth(m_setup->depthRange, depth->value))
            return Fault{row.depth,
                         sentence(depthOutsideText(row.depth->text().trimmed().toStdString(), m_setup->depthRange))};
    }
    if (!isFilled(*row.got))
        return std::nullopt;
    const QString wanted = tr("three coordinates as the program prints them, such as 0.7051 -0.4122 0.0918");
    if (const auto got = writtenNumbers(row.got->text().toStdString(), 3, wanted.toStdString()); !got)
        return Fault{row.got,
                     tr("%1 is not a point: %2", "the field's text, why").arg(quoted(*row.got), ended(got.error()))};
    return std::nullopt;
}

void WrongPointsForm::markFaults()
{
    QString text = m_tableFault;
    for (const auto &row : m_rows) {
        std::optional<Fault> fault = faultOf(*row);
        // No error is shown during typing.
        if (fault && fault->field->hasFocus() && row->left != fault->field)
            fault.reset();
        for (QLineEdit *field : row->fields())
            setRefused(*field, fault && fault->field == field);
        if (fault && text.isEmpty())
            text = fault->text;
    }
    m_fault->setText(text);
    m_fault->setVisible(!text.isEmpty());
}

std::vector<WrongPoint> WrongPointsForm::points() const
{
    std::vector<WrongPoint> points;
    for (const auto &row : m_rows) {
        const std::optional<WrongPoint> point = row->point();
        if (point && !faultOf(*row))
            points.push_back(*point);
    }
    return points;
}

bool WrongPointsForm::isEmpty() const
{
    return std::all_of(m_rows.begin(), m_rows.end(), [](const auto &row) { return row->isEmpty(); });
}

QString WrongPointsForm::fault() const
{
    return m_fault->text();
}

void WrongPointsForm::setSetup(const Setup &setup)
{
    if (m_setup == setup)
        return;
    m_setup = setup;
    markFaults();
}

WrongPointsForm::Row *WrongPointsForm::waitingRow() const
{
    const auto waiting =
        std::find_if(m_rows.begin(), m_rows.end(), [](const auto &row) { return !isFilled(*row->got); });
    return waiting == m_rows.end() ? nullptr : waiting->get();
}

void WrongPointsForm::addClick(const DevicePoint &pixel, const std::optional<double> &depth)
{
    Row *const waiting = waitingRow();
    Row &row = waiting ? *waiting : addRow();
    m_beforeClick = {&row, !waiting, row.pixel->text(), row.clickedPixel, row.depth->text(), row.clickedDepth};
    row.left = nullptr;
    row.clickedPixel = writtenText(pixel.x, 12) + QStringLiteral(", ") + writtenText(pixel.y, 12);
    row.pixel->setText(row.clickedPixel);
    row.pixel->setCursorPosition(0);
    row.setClickedDepth(depth);
    arrange();
    markFaults();
    emit changed();
}

bool WrongPointsForm::takeBackClick()
{
    const std::optional<BeforeClick> before = std::exchange(m_beforeClick, std::nullopt);
    if (!before)
        return false;
    if (before->isNew) {
        removeRow(before->row);
        return true;
    }
    Row &row = *before->row;
    row.pixel->setText(before->pixel);
    row.clickedPixel = before->clickedPixel;
    row.depth->setText(before->depth);
    row.clickedDepth = before->clickedDepth;
    arrange();
    markFaults();
    emit changed();
    return true;
}

std::vector<WrongPointsForm::ClickedRow> WrongPointsForm::takeClickedRows()
{
    const QSignalBlocker blocker(this);
    std::vector<ClickedRow> taken;
    std::vector<const Row *> clicked;
    for (const auto &row : m_rows) {
        if (!row->isOfClick())
            continue;
        clicked.push_back(row.get());
        taken.push_back({row->pixel->text(), row->depth->text(), row->got->text(), row->clickedDepth});
    }
    for (const Row *row : clicked)
        removeRow(row);
    return taken;
}

void WrongPointsForm::putBack(const std::vector<ClickedRow> &rows)
{
    m_beforeClick.reset();
    for (const ClickedRow &each : rows) {
        Row &row = m_rows.back()->isEmpty() ? *m_rows.back() : makeRow();
        row.pixel->setText(each.pixel);
        row.clickedPixel = each.pixel;
        row.depth->setText(each.depth);
        row.clickedDepth = each.clickedDepth;
        row.got->setText(each.got);
        for (QLineEdit *field : row.fields())
            field->setCursorPosition(0);
    }
    arrange();
    markFaults();
}

void WrongPointsForm::forgetClickedDepths()
{
    m_beforeClick.reset();
    for (const auto &row : m_rows) {
        if (row->clickedDepth && row->depth->text() == clickedText(*row->clickedDepth))
            row->setClickedDepth({});
    }
    markFaults();
}

void WrongPointsForm::focusWaiting()
{
    if (const Row *row = waitingRow())
        row->got->setFocus();
}

} // namespace unprojector::gui
