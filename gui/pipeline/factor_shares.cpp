#include "gui/pipeline/factor_shares.h"

#include "gui/pipeline/factor_drawing.h"
#include "gui/pipeline/matrix_model.h"
#include "gui/text/number_text.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/wheel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

namespace {

constexpr int kAll = 100; ///< percent

QString nameOf(ProjectionKind kind)
{
    switch (kind) {
    case ProjectionKind::Frustum: return QStringLiteral("glFrustum");
    case ProjectionKind::Perspective: return QStringLiteral("gluPerspective");
    case ProjectionKind::Ortho: return QStringLiteral("glOrtho");
    case ProjectionKind::Oblique: return FactorShares::tr("the oblique projection");
    }
    Q_UNREACHABLE();
}

QString numberText(double value)
{
    constexpr int kDigits = 4;
    return writtenText(value, kDigits).replace(u'-', u'−');
}

QLabel *wrapped()
{
    auto *label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

} // namespace

FactorShares::FactorShares(QWidget *parent)
    : QWidget(parent), m_model(new MatrixModel(PipelineStage::WholeMatrix, this)), m_said(wrapped()),
      m_extent(wrapped()), m_drawing(new FactorDrawing)
{
    auto *none = new QPushButton(tr("None")), *all = new QPushButton(tr("All"));
    none->setToolTip(tr("Set every factor to 0 %: the view volume stays unchanged"));
    all->setToolTip(tr("Set every factor to 100 %: the whole matrix"));
    none->setAccessibleName(tr("None of the factors"));
    all->setAccessibleName(tr("All of the factors"));
    connect(none, &QPushButton::clicked, this, [this] { setAll(0); });
    connect(all, &QPushButton::clicked, this, [this] { setAll(kAll); });
    auto *head = new QHBoxLayout;
    auto *title = new QLabel(tr("Strength of each factor:"));
    title->setWordWrap(true);
    head->addWidget(title, 1);
    head->addWidget(none);
    head->addWidget(all);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    const int widest = fontMetrics().horizontalAdvance(QStringLiteral("100 %")) + 4;
    for (Row &row : m_rows) {
        row = {new QWidget, new QLabel, new QSlider(Qt::Horizontal), new QLabel};
        row.letter->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("C′")));
        row.slider->setRange(0, kAll);
        row.slider->setPageStep(10);
        row.slider->setValue(kAll);
        ignoreWheelWithoutFocus(row.slider);
        row.slider->setMinimumWidth(60);
        row.percent->setMinimumWidth(widest);
        row.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        auto *line = new QHBoxLayout(row.line);
        line->setContentsMargins(0, 0, 0, 0);
        line->addWidget(row.letter);
        line->addWidget(row.slider, 1);
        line->addWidget(row.percent);
        layout->addWidget(row.line);
        connect(row.slider, &QSlider::valueChanged, this, &FactorShares::showProduct);
    }
    auto *grid = new NumberGrid(m_model);
    grid->setAccessibleName(tr("Product of the active factors"));
    m_said->setAccessibleName(tr("Comparison with the projection matrix"));
    m_extent->setAccessibleName(tr("Bounds of the view volume"));
    // Two lines each, so that nothing below them jumps while a slider moves.
    for (QLabel *label : {m_said, m_extent}) {
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setMinimumHeight(2 * fontMetrics().lineSpacing() + 2);
    }
    layout->addWidget(new QLabel(tr("Their product:")));
    layout->addWidget(grid);
    layout->addWidget(m_said);
    layout->addWidget(m_drawing);
    layout->addWidget(m_extent);
}

void FactorShares::setFactors(const std::vector<MatrixFactor> &factors, const std::vector<Told> &told,
                              const Projection &projection, const glm::dmat4 &clipFromEye, const MatrixView &view)
{
    Q_ASSERT(factors.size() <= m_rows.size() && told.size() == factors.size());
    // The first factors don't count as a change: the sliders may have been set for them.
    const bool areOthers =
        !m_factors.empty()
        && !std::equal(factors.begin(), factors.end(), m_factors.begin(), m_factors.end(),
                       [](const MatrixFactor &a, const MatrixFactor &b) { return a.step == b.step; });
    m_factors = factors;
    m_projection = projection;
    m_clipFromEye = clipFromEye;
    m_model->setView(view);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = m_rows[i];
        row.line->setVisible(i < factors.size());
        if (i >= factors.size())
            continue;
        row.letter->setText(told[i].letter);
        row.letter->setToolTip(told[i].text);
        row.slider->setToolTip(told[i].text);
        row.slider->setAccessibleName(tr("Strength of %1, percent").arg(told[i].letter));
        row.slider->setAccessibleDescription(told[i].text);
    }
    if (areOthers)
        setAll(kAll);
    else
        showProduct();
}

void FactorShares::setAll(int percent)
{
    for (const Row &row : m_rows) {
        const QSignalBlocker blocker(row.slider);
        row.slider->setValue(percent);
    }
    showProduct();
}

QList<int> FactorShares::percents() const
{
    QList<int> percents;
    for (const Row &row : m_rows)
        percents << row.slider->value();
    return percents;
}

void FactorShares::setPercents(const QList<int> &percents)
{
    for (qsizetype i = 0; i < std::min<qsizetype>(percents.size(), std::ssize(m_rows)); ++i) {
        QSlider *slider = m_rows[static_cast<std::size_t>(i)].slider;
        const QSignalBlocker blocker(slider);
        slider->setValue(percents[i]);
    }
    showProduct();
}

void FactorShares::showProduct()
{
    if (m_factors.empty())
        return;
    std::vector<double> shares;
    for (std::size_t i = 0; i < m_factors.size(); ++i) {
        const int percent = m_rows[i].slider->value();
        shares.push_back(percent / double(kAll));
        m_rows[i].percent->setText(QStringLiteral("%1 %").arg(percent));
    }
    const glm::dmat4 product = productOf(m_factors, shares);
    m_model->setMatrix(product, PipelineDirection::Forward, ProjectionKind::Perspective, false);
    const QString name = nameOf(kindOf(m_projection));
    if (std::all_of(shares.begin(), shares.end(), [](double share) { return share == 1.0; })) {
        const double off = differenceUlps(m_factors, m_clipFromEye);
        m_said->setText(off == 0.0 ? tr("This is the matrix of %1, to the last digit.").arg(name)
                                   : tr("This is the matrix of %1, to within %2 ulp (units in the last place).")
                                         .arg(name, significantText(off, 2)));
    } else {
        m_said->setText(tr("At 100 % of each it is the matrix of %1.").arg(name));
    }
    m_drawing->setVolume(m_projection, product);
    const auto &[least, most] = m_drawing->extent();
    m_extent->setText(tr("The view volume reaches from %1 to %2 in x, from %3 to %4 in y, from %5 to %6 in z.")
                          .arg(numberText(least.x), numberText(most.x), numberText(least.y), numberText(most.y),
                               numberText(least.z), numberText(most.z)));
    m_drawing->setAccessibleDescription(m_extent->text());
}

} // namespace unprojector::gui
