#include "gui/lessons/manual_layout.h"

#include "gui/widgets/contrast.h"
#include <QFontDatabase>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QImage>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace unprojector::gui {
namespace {

struct Run {
    int start, length;
    QTextCharFormat format;
};

std::vector<Run> runsOf(const QTextBlock &block)
{
    std::vector<Run> runs;
    for (auto it = block.begin(); !it.atEnd(); ++it)
        runs.push_back({it.fragment().position(), it.fragment().length(), it.fragment().charFormat()});
    return runs;
}

void setFormat(QTextDocument &text, const Run &run, const QTextCharFormat &format)
{
    QTextCursor cursor(&text);
    cursor.setPosition(run.start);
    cursor.setPosition(run.start + run.length, QTextCursor::KeepAnchor);
    cursor.setCharFormat(format);
}

/// The format of code without a fixed font size: the importer sets one, and zoom would not change
/// it.
QTextCharFormat codeFormat(const QTextCharFormat &imported, const ManualColors &colors)
{
    QTextCharFormat format;
    format.setFontFamilies({QFontInfo(QFontDatabase::systemFont(QFontDatabase::FixedFont)).family()});
    format.setFontFixedPitch(true);
    format.setBackground(mixed(colors.page, colors.text, 0.07));
    if (imported.isAnchor()) {
        format.setAnchor(true);
        format.setAnchorHref(imported.anchorHref());
        format.setForeground(colors.link);
    }
    return format;
}

void layOutHeading(QTextBlock block, QTextCursor &cursor, const ManualColors &colors, double line)
{
    const int level = block.blockFormat().headingLevel();
    QTextBlockFormat format;
    format.setTopMargin(level == 1 ? 0.0 : (level == 2 ? 1.3 : 0.9) * line);
    format.setBottomMargin(0.4 * line);
    cursor.mergeBlockFormat(format);
    // The adjustment is a step of Qt's scale: 2 is 1.5 times as large, 1 is 1.2 times.
    QTextCharFormat letters;
    letters.setProperty(QTextFormat::FontSizeAdjustment, std::max(3 - level, 0));
    letters.setFontWeight(QFont::Bold);
    letters.setForeground(colors.heading);
    cursor.select(QTextCursor::BlockUnderCursor);
    cursor.mergeCharFormat(letters);
}

void layOutBlocks(QTextDocument &text, const ManualColors &colors)
{
    const double line = QFontMetricsF(text.defaultFont()).lineSpacing();
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        const bool isCodeBlock = block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)
                                 || block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage);
        for (const Run &run : runsOf(block)) {
            if (run.format.hasProperty(QTextFormat::FontFamilies)) // the importer sets one only for code
                setFormat(text, run, codeFormat(run.format, colors));
            else if (run.format.isAnchor()) {
                QTextCharFormat link = run.format;
                link.setForeground(colors.link);
                setFormat(text, run, link);
            }
        }
        if (block.blockFormat().headingLevel() > 0) {
            layOutHeading(block, cursor, colors, line);
        } else if (isCodeBlock) {
            QTextBlockFormat format;
            format.setBackground(mixed(colors.page, colors.text, 0.07));
            format.setNonBreakableLines(false);
            const auto isCode = [](const QTextBlock &other) {
                return other.isValid() && other.blockFormat().hasProperty(QTextFormat::BlockCodeFence);
            };
            format.setTopMargin(isCode(block.previous()) ? 0.0 : 0.5 * line);
            format.setBottomMargin(isCode(block.next()) ? 0.0 : 0.5 * line);
            cursor.mergeBlockFormat(format);
        } else if (block.textList()) {
            QTextBlockFormat format;
            format.setTopMargin(0.0);
            format.setBottomMargin(0.2 * line);
            cursor.mergeBlockFormat(format);
        }
    }
}

void layOutTable(QTextTable &table, const ManualColors &colors, double line)
{
    QTextTableFormat format = table.format();
    format.setBorder(1.0);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(mixed(colors.page, colors.text, 0.28));
    format.setCellPadding(0.3 * line);
    format.setCellSpacing(0.0);
    format.setTopMargin(0.4 * line);
    format.setBottomMargin(0.3 * line);
    format.setHeaderRowCount(1);
    table.setFormat(format);
    // After code, the importer starts the first cell with an empty block that has the code's
    // margins.
    if (const QTextBlock first = table.firstCursorPosition().block();
        first.text().isEmpty() && first.position() < table.cellAt(0, 0).lastPosition())
        QTextCursor(first).deleteChar();
    for (QTextBlock block = table.firstCursorPosition().block(); block.position() <= table.lastPosition();
         block = block.next()) {
        QTextBlockFormat none;
        none.setTopMargin(0.0);
        none.setBottomMargin(0.0);
        QTextCursor(block).mergeBlockFormat(none);
    }
    for (int column = 0; column < table.columns(); ++column) {
        QTextTableCell cell = table.cellAt(0, column);
        QTextCharFormat head = cell.format();
        head.setBackground(mixed(colors.page, colors.text, 0.09));
        cell.setFormat(head);
        QTextCharFormat bold;
        bold.setFontWeight(QFont::Bold);
        QTextCursor cursor = cell.firstCursorPosition();
        cursor.setPosition(cell.lastCursorPosition().position(), QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(bold);
    }
}

} // namespace

void layOutManual(QTextDocument &text, const ManualColors &colors)
{
    const double line = QFontMetricsF(text.defaultFont()).lineSpacing();
    text.setIndentWidth(1.4 * line);
    layOutBlocks(text, colors);
    for (QTextFrame *frame : text.rootFrame()->childFrames()) {
        if (auto *table = qobject_cast<QTextTable *>(frame))
            layOutTable(*table, colors, line);
    }
}

void fitManualImages(QTextDocument &text, double columnWidth, double ratio)
{
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        for (const Run &run : runsOf(block)) {
            if (!run.format.isImageFormat())
                continue;
            QTextImageFormat format = run.format.toImageFormat();
            // All images are in one folder. Only the name counts, because a translated page may be
            // one folder deeper.
            const QImage image = QImage(QStringLiteral(":/images/") + format.name().section(u'/', -1))
                                     .convertToFormat(QImage::Format_RGB32);
            const double width = std::min<double>(image.width(), columnWidth);
            if (image.isNull() || width < 1.0 || format.width() == width)
                continue;
            const double height = width * image.height() / image.width();
            // Scaled here to its final size, because the text document scales without smoothing.
            QImage scaled =
                image.scaled((QSizeF(width, height) * ratio).toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
            scaled.setDevicePixelRatio(ratio);
            text.addResource(QTextDocument::ImageResource, QUrl(format.name()), scaled);
            format.setWidth(width);
            format.setHeight(height);
            setFormat(text, run, format);
        }
    }
}

} // namespace unprojector::gui
