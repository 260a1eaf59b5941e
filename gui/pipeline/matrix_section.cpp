#include "gui/pipeline/matrix_section.h"

#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/matrix_model.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/number_grid.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace unprojector::gui {
using namespace pipeline;

MatrixSection::MatrixSection(MatrixModel *model, QWidget *parent) : QWidget(parent), m_model(model)
{
    m_heading = new QLabel;
    QFont bold = font();
    bold.setBold(true);
    m_heading->setFont(bold);

    auto *menu = new QMenu(this);
    const auto add = [&](const QString &text, const QString &toolTip, MatrixSyntax syntax) {
        QAction *action = menu->addAction(text, this, [this, syntax] { copyToClipboard(m_model->copyText(syntax)); });
        action->setToolTip(toolTip);
    };
    menu->setToolTipsVisible(true);
    add(tr("&Text"), tr("Four aligned lines, as shown"), MatrixSyntax::Text);
    add(tr("&C array"), tr("m[16] as OpenGL stores it, column after column"), MatrixSyntax::CArray);
    add(tr("&GLM"), tr("A constructor, column after column"), MatrixSyntax::Glm);
    add(tr("&NumPy"), tr("np.array, row after row as shown"), MatrixSyntax::NumPy);
    add(tr("&LaTeX"), tr("A bmatrix, row after row as shown"), MatrixSyntax::Latex);
    add(tr("C&SV"), tr("Four lines of numbers with commas, as shown"), MatrixSyntax::Csv);
    m_copy = new QToolButton;
    m_copy->setText(tr("Copy"));
    m_copy->setAutoRaise(true);
    m_copy->setFocusPolicy(Qt::StrongFocus);
    m_copy->setPopupMode(QToolButton::InstantPopup);
    m_copy->setMenu(menu);
    m_copy->setToolTip(tr("Copy the matrix with all its digits"));

    auto *line = new QHBoxLayout;
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_heading);
    line->addStretch();
    line->addWidget(m_copy);
    m_help = new HelpLink({});
    m_help->hide();
    line->addWidget(m_help);

    m_grid = new NumberGrid(model);
    m_heading->setBuddy(m_grid);
    m_grid->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_grid, &NumberGrid::entered, this,
            [this](const QModelIndex &cell) { emit rowChosen(m_model->mathRowOf(cell)); });
    connect(m_grid, &NumberGrid::reached, this,
            [this](const QModelIndex &cell) { emit rowChosen(m_model->mathRowOf(cell)); });
    // The number under the pointer first, then the whole matrix.
    connect(m_grid, &QWidget::customContextMenuRequested, menu, [this, menu](const QPoint &position) {
        const QPoint place = m_grid->viewport()->mapToGlobal(position);
        auto *shown = new QMenu(this);
        shown->setAttribute(Qt::WA_DeleteOnClose);
        shown->setToolTipsVisible(true);
        addCopyActions(*shown, m_grid->numberAt(place), {});
        shown->addSeparator();
        shown->addActions(menu->actions());
        shown->popup(place);
    });
    m_product = new QLabel;
    m_product->setIndent(4);
    m_product->setWordWrap(true);
    m_grid->setAccessibleDescription(
        tr("Rows and columns of the matrix; Copy takes the selected numbers with all digits"));

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(line);
    layout->addWidget(m_product);
    layout->addWidget(m_grid);
}

void MatrixSection::putBelowNumbers(QWidget *widget)
{
    auto *rows = static_cast<QVBoxLayout *>(layout());
    if (rows->indexOf(widget) < 0)
        rows->insertWidget(rows->indexOf(m_grid) + 1, widget);
}

FactorsView *MatrixSection::addFactors()
{
    m_takeApart = new QToolButton;
    m_takeApart->setText(tr("Decompose"));
    m_takeApart->setToolTip(tr("Show the factors of the matrix and the effect of each"));
    m_takeApart->setObjectName(QStringLiteral("takeApart"));
    m_takeApart->setAutoRaise(true);
    m_takeApart->setCheckable(true);
    m_takeApart->setFocusPolicy(Qt::StrongFocus);
    m_factors = new FactorsView;
    m_factors->hide();
    layout()->addWidget(m_factors);
    auto *line = static_cast<QHBoxLayout *>(layout()->itemAt(0)->layout());
    line->insertWidget(line->indexOf(m_copy), m_takeApart);
    connect(m_takeApart, &QToolButton::toggled, this, [this](bool isApart) {
        m_factors->setVisible(isApart);
        if (isApart)
            emit factorsOpened();
    });
    return m_factors;
}

void MatrixSection::setHelp(const QString &anchor)
{
    m_help->setAnchor(anchor);
    m_help->show();
}

void MatrixSection::setApart(bool isApart)
{
    m_takeApart->setChecked(isApart);
}

bool MatrixSection::isApart() const
{
    return m_takeApart && m_takeApart->isChecked();
}

bool MatrixSection::showsFactors() const
{
    return !isHidden() && isApart();
}

void MatrixSection::setTitle(const QString &title, const QString &name, const QString &product)
{
    m_heading->setText(title);
    m_copy->setAccessibleName(tr("Copy %1").arg(name));
    if (m_takeApart)
        m_takeApart->setAccessibleName(tr("Decompose %1").arg(name));
    m_grid->setAccessibleName(title);
    m_product->setText(product);
    m_product->setVisible(!product.isEmpty());
}

} // namespace unprojector::gui
