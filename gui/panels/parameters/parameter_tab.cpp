#include "gui/panels/parameters/parameter_tab.h"

#include "gui/text/error_text.h"

#include <QEvent>
#include <QLabel>
#include <QPalette>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// More fields than this are hardly ever refused at once; the sets of them are tried one by one.
constexpr std::size_t kMostTriedTogether = 4;
constexpr int kReasonLines = 3;
constexpr int kMostShownCharacters = 20;

} // namespace

ParameterTab::ParameterTab(SceneDocument &document, Changes shown, QWidget *parent)
    : QWidget(parent), m_document(document)
{
    auto *inside = new QWidget;
    m_content = new QVBoxLayout(inside);
    m_content->setContentsMargins(8, 6, 8, 6);
    m_content->setSpacing(4);

    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(inside);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    // The panel's own colour, not that of a list.
    m_scroll->viewport()->setAutoFillBackground(false);
    inside->setAutoFillBackground(false);

    m_reasonLabel = new QLabel;
    m_reasonLabel->setAccessibleName(tr("Why the number is not taken"));
    m_reasonLabel->setTextFormat(Qt::PlainText);
    m_reasonLabel->setWordWrap(true);
    m_reasonLabel->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_reasonLabel->setContentsMargins(8, 0, 8, 2);
    m_reasonLabel->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QPalette palette = m_reasonLabel->palette();
    const QColor ink = palette.color(QPalette::WindowText);
    palette.setColor(QPalette::WindowText, QColor((ink.red() + 3 * 200) / 4, ink.green() / 2, ink.blue() / 2));
    m_reasonLabel->setPalette(palette);
    m_reasonLabel->setFixedHeight(kReasonLines * m_reasonLabel->fontMetrics().lineSpacing() + 4);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_scroll, 1);
    layout->addWidget(m_reasonLabel);

    connect(&m_document, &SceneDocument::changed, this, [this, shown](Changes changes) {
        if (!(changes & shown))
            return;
        if (isVisible())
            refresh();
        else
            m_isStale = true;
    });
}

ParameterTab::~ParameterTab() = default;

QLabel *ParameterTab::heading(const QString &text)
{
    auto *label = new QLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

NumberField *ParameterTab::addField(NumberBinding binding)
{
    auto *widget = new NumberField(binding.name, binding.help);
    const FieldPointer field = std::make_shared<Field>(Field{widget, std::move(binding)});
    m_fields.push_back(field);
    connect(widget, &NumberField::edited, this, [this, field] { apply(field); });
    connect(widget, &NumberField::entered, this, [this, field] {
        if (field->widget->isBad())
            apply(field);
        if (isThere(field) && !field->widget->isBad())
            field->widget->selectAll();
    });
    connect(widget, &NumberField::reasonChanged, this, &ParameterTab::showReason);
    return widget;
}

void ParameterTab::removeFieldsIn(QWidget *container)
{
    std::erase_if(m_fields, [&](const FieldPointer &field) {
        if (!container->isAncestorOf(field->widget))
            return false;
        // It may be the one whose signal brought us here.
        field->widget->disconnect(this);
        return true;
    });
    container->hide();
    container->deleteLater();
    showReason();
}

void ParameterTab::restoreFields()
{
    m_otherReason.clear();
    for (const FieldPointer &field : m_fields) {
        if (field->widget->isBad())
            field->widget->restore();
    }
    showReason();
}

void ParameterTab::bringUp(NumberField *field)
{
    field->setFocus(Qt::TabFocusReason);
    field->selectAll();
    // Its place is known only after the layout.
    QTimer::singleShot(0, field, [this, field] { m_scroll->ensureWidgetVisible(field); });
}

void ParameterTab::ignoreWheelWithoutFocus(QWidget *widget)
{
    widget->setFocusPolicy(Qt::StrongFocus);
    widget->installEventFilter(this);
}

bool ParameterTab::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Wheel && !static_cast<QWidget *>(watched)->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ParameterTab::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale)
        refresh();
}

void ParameterTab::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showReason();
}

void ParameterTab::refresh()
{
    m_isStale = false;
    m_otherReason.clear();
    showScene();
    const Scene &scene = m_document.scene();
    for (const FieldPointer &field : m_fields) {
        if (const std::optional<double> value = field->binding.read(scene))
            field->widget->setValue(*value);
        else if (field->widget->isBad())
            field->widget->restore();
    }
    updateReasons();
}

bool ParameterTab::change(const Scene &next, const QString &text)
{
    const Check changed = edit(next, {text});
    if (!changed)
        refresh(); // the combo box or check box goes back
    m_otherReason = changed ? QString() : errorText(changed.error());
    showReason();
    return changed.hasValue();
}

bool ParameterTab::isThere(const FieldPointer &field) const
{
    return field->widget && std::find(m_fields.begin(), m_fields.end(), field) != m_fields.end();
}

Check ParameterTab::changeTogether(const std::vector<FieldPointer> &fields, const Deed &deed)
{
    Scene next = m_document.scene();
    for (const FieldPointer &field : fields)
        field->binding.write(next, *field->widget->typed());
    const Check changed = edit(next, deed);
    if (changed) {
        // A good number that is the document's own brings no change of the field's value.
        for (const FieldPointer &field : fields) {
            if (!isThere(field))
                continue;
            field->widget->setReason({});
            if (const std::optional<double> value = field->binding.read(m_document.scene()))
                field->widget->setValue(*value);
        }
    }
    return changed;
}

std::vector<ParameterTab::FieldPointer> ParameterTab::refusedBut(const FieldPointer &other) const
{
    std::vector<FieldPointer> refused;
    for (const FieldPointer &field : m_fields) {
        NumberField *widget = field->widget;
        if (field == other || !widget->isBad() || !widget->typed() || refused.size() == kMostTriedTogether)
            continue;
        if (!field->binding.refusal || field->binding.refusal(*widget->typed()).isEmpty())
            refused.push_back(field);
    }
    return refused;
}

void ParameterTab::apply(const FieldPointer &field)
{
    m_otherReason.clear();
    const std::optional<double> typed = field->widget->typed();
    const std::vector<FieldPointer> refused = refusedBut(field);
    const std::optional<double> current = field->binding.read(m_document.scene());
    const bool isForbidden = !typed || (field->binding.refusal && !field->binding.refusal(*typed).isEmpty());
    if (isForbidden || !current) {
        field->widget->setReason(refusalOf(*field));
        showReason();
        return;
    }
    const QString mergeKey = QStringLiteral("%1 #%2").arg(field->binding.name).arg(field->widget->session());

    // All of them, else the sets with one less, and so on down to this field alone.
    const unsigned all = 1u << refused.size();
    std::vector<unsigned> sets;
    for (unsigned set = 0; set < all; ++set)
        sets.push_back(set);
    const auto sizeOf = [](unsigned set) {
        int size = 0;
        for (; set != 0; set &= set - 1)
            ++size;
        return size;
    };
    std::stable_sort(sets.begin(), sets.end(), [&](unsigned a, unsigned b) { return sizeOf(a) > sizeOf(b); });
    for (const unsigned set : sets) {
        std::vector<FieldPointer> together{field};
        for (std::size_t i = 0; i < refused.size(); ++i) {
            if (set & (1u << i))
                together.push_back(refused[i]);
        }
        if (together.size() == 1 && *current == *typed) {
            field->widget->setReason({});
            showReason();
            return;
        }
        if (changeTogether(together, {field->binding.name, mergeKey})) {
            updateReasons();
            return;
        }
    }
    field->widget->setReason(refusalOf(*field));
    showReason();
}

QString ParameterTab::refusalOf(const Field &field) const
{
    const QString text = field.widget->text().trimmed();
    const std::optional<double> typed = field.widget->typed();
    if (!typed) {
        if (text.isEmpty())
            return tr("%1 is empty; type a number.").arg(field.binding.name);
        const QString shown = text.size() > kMostShownCharacters ? text.left(kMostShownCharacters) + u'…' : text;
        return tr("“%1” is not a number; type one such as 0.5 or 1e-3.").arg(shown);
    }
    if (field.binding.refusal) {
        if (const QString reason = field.binding.refusal(*typed); !reason.isEmpty())
            return reason;
    }
    Scene next = m_document.scene();
    field.binding.write(next, *typed);
    const Result<Picture> geometry = pictureOf(next, m_document.geometry().surface, m_document.ground());
    return geometry ? QString() : errorText(geometry.error());
}

void ParameterTab::updateReasons()
{
    for (const FieldPointer &field : m_fields) {
        if (!field->widget->isBad())
            continue;
        const QString reason = refusalOf(*field);
        field->widget->setReason(reason.isEmpty() ? tr("%1 can be taken now; press Enter.").arg(field->binding.name)
                                                  : reason);
    }
    showReason();
}

QString ParameterTab::reason() const
{
    return m_reasonLabel->text();
}

void ParameterTab::showReason()
{
    QString reason = m_otherReason;
    for (const FieldPointer &field : m_fields) {
        if (field->widget->isBad() && (reason.isEmpty() || field->widget->hasFocus()))
            reason = field->widget->reason();
    }
    if (reason == m_reasonLabel->text())
        return;
    m_reasonLabel->setText(reason);
    m_reasonLabel->setToolTip(plainToolTip(reason));
    m_reasonLabel->setAccessibleDescription(reason);
}

} // namespace unprojector::gui
