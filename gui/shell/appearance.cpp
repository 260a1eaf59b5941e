#include "gui/shell/appearance.h"

#include "gui/text/named_values.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleOption>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr NamedValues<Appearance, 3> kNames{
    {{Appearance::Desktop, "desktop"}, {Appearance::Light, "light"}, {Appearance::Dark, "dark"}}};

const QString kFusion = QStringLiteral("fusion");

/// Fonts with Chinese glyphs on Windows, macOS and Linux.
const QStringList kChineseFonts{QStringLiteral("Microsoft YaHei UI"), QStringLiteral("PingFang SC"),
                                QStringLiteral("Noto Sans CJK SC"),   QStringLiteral("Noto Sans SC"),
                                QStringLiteral("Source Han Sans SC"), QStringLiteral("WenQuanYi Micro Hei")};

Appearance &current()
{
    static Appearance appearance = Appearance::Desktop;
    return appearance;
}

/// Fusion shortens "浅色(&L)" to the room of "浅色(L)", but Qt's elision also counts the ampersand.
class RoomyFusion : public QProxyStyle {
public:
    RoomyFusion() : QProxyStyle(kFusion) {}

    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                           const QWidget *widget) const override
    {
        QSize needed = QProxyStyle::sizeFromContents(type, option, size, widget);
        if (type == CT_MenuItem)
            needed.rwidth() += option->fontMetrics.horizontalAdvance(u'&');
        return needed;
    }
};

/// Fusion draws the edge of a check box darker than the window: on a dark one it is invisible.
class DarkFusion : public RoomyFusion {
public:
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)
            return;
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->setBrush(Qt::NoBrush);
        if (element == PE_IndicatorCheckBox) {
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        } else {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0));
        }
        painter->restore();
    }
};

QPalette paletteOf(const QColor &window, const QColor &base, const QColor &alternate, const QColor &button,
                   const QColor &text, const QColor &link, const QColor &highlight, const QColor &faint)
{
    QPalette palette(button, window);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, alternate);
    // Panels use it as well, as the background of banners.
    palette.setColor(QPalette::ToolTipBase,
                     text.lightnessF() < 0.5F ? QColor(0xff, 0xff, 0xdc) : QColor(0x4a, 0x44, 0x24));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
        palette.setColor(role, text);
    palette.setColor(QPalette::Link, link);
    palette.setColor(QPalette::Highlight, highlight);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, faint);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faint);
    return palette;
}

/// Sets style sheets and texts with links again: Qt keeps the colours from the time when they were
/// set.
void setAgainWhatKeepsItsColours()
{
    for (QWidget *widget : QApplication::allWidgets()) {
        if (const QString sheet = widget->styleSheet(); !sheet.isEmpty()) {
            widget->setStyleSheet({});
            widget->setStyleSheet(sheet);
        }
        auto *label = qobject_cast<QLabel *>(widget);
        if (!label || !label->text().contains(QStringLiteral("<a ")))
            continue;
        const QString text = label->text();
        label->setText({});
        label->setText(text);
    }
}

} // namespace

std::optional<Appearance> appearanceOf(const QString &name)
{
    return valueNamed(name, kNames);
}

QString appearanceName(Appearance appearance)
{
    return nameAmong(kNames, appearance);
}

Appearance currentAppearance()
{
    return current();
}

void setAppearance(Appearance appearance)
{
    static const QString desktopStyle = QApplication::style()->objectName();
    current() = appearance;
    if (appearance == Appearance::Desktop) {
        if (desktopStyle == kFusion)
            QApplication::setStyle(new RoomyFusion);
        else
            QApplication::setStyle(desktopStyle);
        QApplication::setPalette(QPalette()); // restores the desktop's palette
        setAgainWhatKeepsItsColours();
        return;
    }
    // The only style that draws every control in any colours.
    QApplication::setStyle(appearance == Appearance::Dark ? new DarkFusion : new RoomyFusion);
    QApplication::setPalette(
        appearance == Appearance::Dark
            ? paletteOf(QColor(0x2b, 0x2d, 0x30), QColor(0x1f, 0x20, 0x23), QColor(0x26, 0x28, 0x2b),
                        QColor(0x3a, 0x3d, 0x41), QColor(0xe6, 0xe7, 0xe9), QColor(0x7a, 0xb4, 0xf5),
                        QColor(0x2f, 0x6c, 0xb3), QColor(0x8b, 0x8f, 0x96))
            : paletteOf(QColor(0xef, 0xef, 0xef), Qt::white, QColor(0xf6, 0xf6, 0xf6), QColor(0xef, 0xef, 0xef),
                        Qt::black, QColor(0x1f, 0x4e, 0x8c), QColor(0x30, 0x8c, 0xc6), QColor(0x80, 0x80, 0x80)));
    setAgainWhatKeepsItsColours();
}

void preferHanziOfChina()
{
    const QLocale::Language desktops = QLocale::system().language();
    if (desktops == QLocale::Chinese || desktops == QLocale::Japanese || desktops == QLocale::Korean)
        return;
    const auto found = std::find_if(kChineseFonts.begin(), kChineseFonts.end(),
                                    [](const QString &family) { return QFontDatabase::hasFamily(family); });
    if (found == kChineseFonts.end())
        return;
    QFont font = QApplication::font();
    // The real name is needed: Qt would treat a family such as "Sans Serif" as missing.
    font.setFamilies({QFontInfo(font).family(), *found});
    QApplication::setFont(font);
}

} // namespace unprojector::gui
