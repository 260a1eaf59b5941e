#include "gui/widgets/digits_font.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QStringList>
#include <QTextLayout>

#include <cmath>

namespace unprojector::gui {
namespace {

constexpr double kDigitsScale = 0.88; ///< fixed fonts are drawn larger than others of their size

} // namespace

QFont digitsFont(const QFont &text)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(text.pointSizeF() * kDigitsScale);
    return font;
}

QFont headsFont(const QFont &text)
{
    QFont font = text;
    font.setFamilies({QFontInfo(text).family()});
    font.setPointSizeF(text.pointSizeF());
    return font;
}

int lineHeight(const QFont &font, const QString &text)
{
    QTextLayout layout(text, font);
    layout.beginLayout();
    const QTextLine line = layout.createLine();
    layout.endLayout();
    return static_cast<int>(std::ceil(line.height()));
}

} // namespace unprojector::gui
