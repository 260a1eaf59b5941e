#include "gui/click/api_clicks_view.h"

#include "gui/text/api_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/whole_table.h"

#include <QLabel>
#include <QVBoxLayout>

#include <array>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

enum Column { Position, Depth, Ndc, Eye, World, ColumnCount };
constexpr int kNumbersRole = Qt::UserRole;
constexpr std::array kVariables{"position", "depth", "ndc", "eye", "world"};

QString bracketed(const QStringList &numbers)
{
    return QStringLiteral("(%1)").arg(numbers.join(QStringLiteral(", ")));
}

struct Cell {
    QString text;
    std::vector<double> numbers;
};

std::array<Cell, ColumnCount> cellsOf(const Pick &pick, Api api, const ApiClick &click)
{
    constexpr int kNdcDigits = 6;
    const glm::dvec3 &n = click.ndc, &e = click.eye, &w = click.world;
    const bool isDistance = api == Api::OpenCv;
    return {
        {{bracketed({pixelText(click.position.x), pixelText(click.position.y)}), {click.position.x, click.position.y}},
         {isDistance ? certainText(click.depth, pick.uncertainty.eye.z) : depthText(click.depth), {click.depth}},
         {bracketed({writtenText(n.x, kNdcDigits), writtenText(n.y, kNdcDigits), writtenText(n.z, kNdcDigits)}),
          {n.x, n.y, n.z}},
         {pointText(EyePoint(e), pick.uncertainty.eye), {e.x, e.y, e.z}},
         {pointText(WorldPoint(w), pick.uncertainty.world), {w.x, w.y, w.z}}}};
}

} // namespace

ApiClicksView::ApiClicksView(QWidget *parent)
    : QWidget(parent), m_table(new WholeTable(static_cast<int>(kApis.size()), ColumnCount)),
      m_none(new QLabel(tr("Click a surface to see them.")))
{
    m_table->setAccessibleName(tr("In other APIs"));
    m_table->setHorizontalHeaderLabels({tr("Pixel"), tr("Depth"), tr("NDC"), tr("Eye"), tr("World")});
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    for (const Api api : kApis) {
        const int row = static_cast<int>(api);
        auto *head = new QTableWidgetItem(QString::fromUtf8(conventionsOf(api).name));
        head->setToolTip(apiText(api));
        m_table->setVerticalHeaderItem(row, head);
        for (int column = 0; column < ColumnCount; ++column)
            m_table->item(row, column)->setToolTip(apiText(api));
    }
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table);
    layout->addWidget(m_none);
    connect(m_table, &QTableWidget::customContextMenuRequested, this, &ApiClicksView::showMenu);
    setPick(std::nullopt);
}

void ApiClicksView::setPick(const std::optional<Pick> &pick)
{
    m_plain.clear();
    const bool hasPoint = pick && pick->hit() && pick->point.eye[Method::Formula] && pick->point.world[Method::Formula];
    m_table->setVisible(hasPoint);
    m_none->setVisible(!hasPoint);
    for (const Api api : kApis) {
        const auto click = hasPoint ? apiClick(pick->setup, api, pick->window, *pick->point.eye[Method::Formula],
                                               *pick->point.world[Method::Formula])
                                    : Result<ApiClick>(Error{ErrorCode::NotFinite});
        std::array<Cell, ColumnCount> cells;
        cells.fill({QStringLiteral("–"), {}});
        if (click) {
            cells = cellsOf(*pick, api, *click);
            m_plain += QString::fromUtf8(conventionsOf(api).name);
        }
        for (int column = 0; column < ColumnCount; ++column) {
            const Cell &cell = cells[static_cast<std::size_t>(column)];
            QTableWidgetItem *item = m_table->item(static_cast<int>(api), column);
            item->setText(cell.text);
            item->setData(kNumbersRole, QVariant::fromValue(QList<double>(cell.numbers.begin(), cell.numbers.end())));
            for (const double number : cell.numbers)
                m_plain += QLatin1Char('\t') + shortestText(number);
        }
        m_plain += click ? QStringLiteral("\n") : QString();
    }
    m_table->fit();
}

void ApiClicksView::setScenes(Api scenes)
{
    for (const Api api : kApis) {
        QTableWidgetItem *head = m_table->verticalHeaderItem(static_cast<int>(api));
        QFont font = head->font();
        font.setBold(api == scenes);
        head->setFont(font);
    }
}

void ApiClicksView::showMenu(const QPoint &position)
{
    const QTableWidgetItem *item = m_table->itemAt(position);
    if (!item)
        return;
    const QList<double> numbers = item->data(kNumbersRole).value<QList<double>>();
    showCopyMenu(*m_table, m_table->viewport()->mapToGlobal(position), {},
                 {QString::fromUtf8(kVariables[static_cast<std::size_t>(item->column())]),
                  std::vector<double>(numbers.begin(), numbers.end())});
}

} // namespace unprojector::gui
