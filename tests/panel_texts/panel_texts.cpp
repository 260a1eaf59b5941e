#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QGenericPlugin>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextDocumentFragment>
#include <QTextEdit>
#include <QToolButton>

#include <algorithm>

namespace {

/// A rich text without its tags.
QString plain(const QString &text)
{
    return Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
}

/// A line a row: the headers and the cells of a model, children below their parent.
void appendRows(QStringList &lines, const QAbstractItemModel &model, const QModelIndex &parent)
{
    constexpr int kMostRows = 200;
    const QString indent(lines.isEmpty() || !parent.isValid() ? 0 : 2, u' ');
    for (int row = 0; row < std::min(model.rowCount(parent), kMostRows); ++row) {
        QStringList cells{model.headerData(row, Qt::Vertical).toString()};
        for (int column = 0; column < model.columnCount(parent); ++column)
            cells << plain(model.index(row, column, parent).data().toString());
        lines << indent + cells.join(u" | ");
        appendRows(lines, model, model.index(row, 0, parent));
    }
}

/// What a widget itself shows, without its children; nothing for a container.
QStringList ownLines(QWidget &widget)
{
    if (qobject_cast<QScrollBar *>(&widget))
        return {};
    if (const auto *label = qobject_cast<QLabel *>(&widget))
        return {plain(label->text())};
    if (const auto *button = qobject_cast<QAbstractButton *>(&widget))
        return {button->text() + QLatin1String(!button->isCheckable() ? "" : button->isChecked() ? " [x]" : " [ ]")};
    if (const auto *edit = qobject_cast<QLineEdit *>(&widget))
        return {edit->text()};
    if (const auto *edit = qobject_cast<QTextEdit *>(&widget))
        return {edit->toPlainText()};
    if (const auto *edit = qobject_cast<QPlainTextEdit *>(&widget))
        return {edit->toPlainText()};
    if (const auto *box = qobject_cast<QComboBox *>(&widget))
        return {box->currentText()};
    if (const auto *box = qobject_cast<QAbstractSpinBox *>(&widget))
        return {box->text()};
    if (const auto *box = qobject_cast<QGroupBox *>(&widget))
        return {box->title()};
    if (const auto *view = qobject_cast<QAbstractItemView *>(&widget); view && view->model()) {
        QStringList headers;
        for (int column = 0; column < view->model()->columnCount(); ++column)
            headers << view->model()->headerData(column, Qt::Horizontal).toString();
        QStringList lines{headers.join(u" | ")};
        appendRows(lines, *view->model(), {});
        return lines;
    }
    // A widget that paints its text tells it to screen readers.
    if (QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&widget))
        return {spoken->text(QAccessible::Name), spoken->text(QAccessible::Value)};
    return {};
}

/// What a widget and its children show; parts of a table, of a combo box repeat what it shows.
void append(QStringList &lines, QWidget &widget)
{
    lines << ownLines(widget);
    if (qobject_cast<QComboBox *>(&widget) || qobject_cast<QAbstractSpinBox *>(&widget)
        || qobject_cast<QAbstractItemView *>(&widget) || qobject_cast<QScrollBar *>(&widget))
        return;
    for (QObject *child : widget.children()) {
        if (auto *part = qobject_cast<QWidget *>(child); part && part->isVisibleTo(&widget) && !part->isWindow())
            append(lines, *part);
    }
}

void processEventsFor(int milliseconds)
{
    QElapsedTimer timer;
    timer.start();
    while (!timer.hasExpired(milliseconds))
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

/// The texts of all docks of a window, each of them shown and in front of its neighbours.
QStringList panelTexts(const QMainWindow &window)
{
    constexpr int kUpdateMilliseconds = 150;
    QList<QDockWidget *> docks = window.findChildren<QDockWidget *>();
    std::ranges::sort(docks, {}, [](const QDockWidget *dock) { return dock->objectName(); });
    QStringList lines;
    for (QDockWidget *dock : docks) {
        dock->show();
        dock->raise();
        processEventsFor(kUpdateMilliseconds);
        for (QToolButton *head : dock->findChildren<QToolButton *>()) {
            if (head->arrowType() == Qt::RightArrow && head->isVisibleTo(dock))
                head->click(); // opens a fold
        }
        processEventsFor(kUpdateMilliseconds);
        lines << QStringLiteral("== ") + dock->objectName();
        if (dock->widget())
            append(lines, *dock->widget());
        dock->hide();
    }
    return lines;
}

} // namespace

/// Writes what each panel shows, when the program ends:
/// QT_PLUGIN_PATH=FOLDER QT_QPA_GENERIC_PLUGINS=panel_texts:FILE unprojector …. It knows the program
/// only by the names of its docks, so that it works with every version.
class PanelTexts : public QGenericPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "panel_texts.json")

public:
    QObject *create(const QString & /*key*/, const QString &specification) override
    {
        QObject::connect(qApp, &QCoreApplication::aboutToQuit, qApp, [specification] {
            QStringList lines;
            for (QWidget *widget : QApplication::topLevelWidgets()) {
                if (const auto *window = qobject_cast<QMainWindow *>(widget))
                    lines << panelTexts(*window);
            }
            lines.removeAll(QString());
            QString text = lines.join(u'\n') + u'\n';
            // Durations differ from run to run.
            static const QRegularExpression duration(QStringLiteral("[0-9.]+[ \u00a0]?(ns|µs|μs|ms|s|毫秒|微秒)\\b"));
            text.replace(duration, QStringLiteral("a duration"));
            QFile file(specification);
            if (file.open(QIODevice::WriteOnly))
                file.write(text.toUtf8());
        });
        return new QObject;
    }
};

#include "panel_texts.moc"
