#include "gui/view/letter_places.h"

#include "gui/view/highlight_marks.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::gui {
namespace {

using Tips = HighlightMarks::Tips;

/// The gaps from a tip, or the line of a length, to the box; the last is the largest without a
/// leader.
constexpr std::array kGaps{5.0, 9.0, 14.0};

double lengthOf(const QPointF &way)
{
    return std::hypot(way.x(), way.y());
}

QPointF nearestOf(const QRectF &box, const QPointF &point)
{
    return {std::clamp(point.x(), box.left(), box.right()), std::clamp(point.y(), box.top(), box.bottom())};
}

double distanceOf(const QRectF &box, const QPointF &point)
{
    return lengthOf(nearestOf(box, point) - point);
}

double distanceOf(const QLineF &line, const QPointF &point)
{
    const QPointF way = line.p2() - line.p1();
    const double square = QPointF::dotProduct(way, way);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(point - line.p1(), way) / square, 0.0, 1.0) : 0.0;
    return lengthOf(line.p1() + way * share - point);
}

bool areCrossed(const QRectF &box, const QLineF &line)
{
    const std::array edges{QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
                           QLineF(box.bottomRight(), box.bottomLeft()), QLineF(box.bottomLeft(), box.topLeft())};
    return box.contains(line.p1()) || std::any_of(edges.begin(), edges.end(), [&line](const QLineF &edge) {
               return edge.intersects(line) == QLineF::BoundedIntersection;
           });
}

double distanceOf(const QRectF &box, const QLineF &line)
{
    if (areCrossed(box, line))
        return 0.0;
    double least = std::min(distanceOf(box, line.p1()), distanceOf(box, line.p2()));
    for (const QPointF &corner : {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()})
        least = std::min(least, distanceOf(line, corner));
    return least;
}

/// The directions of candidates from a tip, degrees from the preferred direction.
constexpr std::array kTurns{0.0, 35.0, -35.0, 70.0, -70.0, 105.0, -105.0, 140.0, -140.0, 180.0};

/// A box whose nearest side is at this distance from a point, in a direction from it.
QRectF boxAt(const QPointF &point, const QPointF &way, double gap, const QSizeF &size)
{
    const double across = size.width() / 2.0 + gap, down = size.height() / 2.0 + gap;
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double x = std::abs(way.x()), y = std::abs(way.y());
    const double reach = std::min(x > 0.0 ? across / x : kEndless, y > 0.0 ? down / y : kEndless);
    return {point + way * reach - QPointF(size.width() / 2.0, size.height() / 2.0), size};
}

QPointF turned(const QPointF &way, double degrees)
{
    const double angle = degrees * std::acos(-1.0) / 180.0;
    return {way.x() * std::cos(angle) - way.y() * std::sin(angle),
            way.x() * std::sin(angle) + way.y() * std::cos(angle)};
}

/// Places letters one by one, each clear of those placed before.
class Placer {
public:
    Placer(const HighlightMarks &marks, const QFont &font, const QRectF &area, const std::vector<QRectF> &taken)
        : m_marks(marks), m_letter(letterFont(font)), m_index(letterIndexFont(m_letter)), m_area(area), m_taken(taken)
    {
        for (const HighlightMarks::Arrow &arrow : marks.arrows) {
            if (isEndOn(arrow))
                m_taken.push_back(QRectF(arrow.line.p2(), QSizeF()).adjusted(-kRing, -kRing, kRing, kRing));
            else
                m_lines.push_back(arrow.line);
        }
        // The middle of the view is the subject of a step.
        m_middle = QRectF(area.topLeft() + QPointF(area.width(), area.height()) / 4.0, area.size() / 2.0);
    }

    QRectF place(std::size_t text)
    {
        QRectF box = isLength(text) ? placeBesideLine(text) : placeAtTip(text);
        if (box.isNull())
            box = placeWithLeader(text);
        if (!box.isNull()) {
            m_taken.push_back(box);
            if (const std::optional<QLineF> leader = leaderOf(m_marks, text, box))
                m_lines.push_back(*leader);
        }
        return box;
    }

    /// The distance to the next tip: the letter with the closest neighbour has the fewest
    /// positions.
    double roomOf(std::size_t text) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < m_marks.texts.size(); ++other) {
            if (other != text)
                least = std::min(least, lengthOf(m_marks.texts[other].at - m_marks.texts[text].at));
        }
        return isLength(text) ? std::numeric_limits<double>::infinity() : least;
    }

private:
    /// The conditions on a position, in addition to being free.
    struct Wish {
        double nearer;          ///< so many times farther from any other than from its own
        bool isClear;           ///< of the scene's lines and marks
        bool isOutside = false; ///< of the middle of the area
    };

    static bool isEndOn(const HighlightMarks::Arrow &arrow)
    {
        return arrow.tips == Tips::Towards || arrow.tips == Tips::Away;
    }
    const HighlightMarks::Arrow *arrowOf(std::size_t text) const
    {
        const std::optional<std::size_t> &arrow = m_marks.texts[text].arrow;
        return arrow ? &m_marks.arrows[*arrow] : nullptr;
    }
    bool isLength(std::size_t text) const
    {
        const HighlightMarks::Arrow *arrow = arrowOf(text);
        return arrow && gui::isLength(*arrow);
    }
    QSizeF sizeOf(std::size_t text) const
    {
        const Letter &letter = m_marks.texts[text].letter;
        const QFontMetricsF metrics(m_letter), ofIndex(m_index);
        constexpr double kRim = 2.0;
        return {metrics.horizontalAdvance(QString::fromStdString(letter.letter))
                    + ofIndex.horizontalAdvance(QString::fromStdString(letter.index)) + 2.0 * kRim,
                metrics.height()};
    }

    bool isFree(const QRectF &box) const
    {
        return m_area.contains(box)
               && std::none_of(m_taken.begin(), m_taken.end(), [&](const QRectF &one) { return one.intersects(box); })
               && std::none_of(m_lines.begin(), m_lines.end(),
                               [&](const QLineF &line) { return distanceOf(box, line) < kHalfHead; });
    }
    bool isClear(const QRectF &box) const
    {
        const auto isOn = [&box](const auto &one) {
            if constexpr (requires { areCrossed(box, one); })
                return areCrossed(box, one);
            else
                return one.intersects(box);
        };
        return std::none_of(m_marks.lines.begin(), m_marks.lines.end(), isOn)
               && std::none_of(m_marks.things.begin(), m_marks.things.end(), isOn);
    }
    /// The distance to the line of a length, else to the tip or point.
    double distanceTo(std::size_t text, const QRectF &box) const
    {
        return isLength(text) ? distanceOf(box, arrowOf(text)->line) : distanceOf(box, m_marks.texts[text].at);
    }
    /// Returns whether the letter cannot be attributed to another tip.
    bool isItsOwn(std::size_t text, const QRectF &box, double nearer) const
    {
        constexpr double kSamePlace = 4.0; // closer tips cannot be told apart by distance
        const double own = distanceTo(text, box);
        const HighlightMarks::Text &mine = m_marks.texts[text];
        for (std::size_t other = 0; other < m_marks.texts.size(); ++other) {
            if (other == text || isLength(other) != isLength(text))
                continue;
            const HighlightMarks::Text &one = m_marks.texts[other];
            if (!isLength(text) && lengthOf(one.at - mine.at) > kSamePlace && distanceOf(box, one.at) < nearer * own)
                return false;
            // Also not beside the shaft of another arrow of its kind.
            const HighlightMarks::Arrow *arrow = arrowOf(other);
            if (arrow && (isLength(text) || (one.letter.letter == mine.letter.letter && !isEndOn(*arrow)))
                && distanceOf(arrow->line, mine.at) > kSamePlace && distanceOf(box, arrow->line) < own)
                return false;
        }
        return true;
    }
    bool isAsWished(std::size_t text, const QRectF &box, const Wish &wish) const
    {
        return isFree(box) && isItsOwn(text, box, wish.nearer) && !(wish.isClear && !isClear(box))
               && !(wish.isOutside && box.intersects(m_middle));
    }

    QRectF placeAtTip(std::size_t text) const
    {
        const HighlightMarks::Arrow *arrow = arrowOf(text);
        const bool isEnd = arrow && arrow->tips == Tips::End;
        const QPointF way = isEnd ? (arrow->line.p2() - arrow->line.p1()) / arrow->line.length() : QPointF(1.0, 0.0);
        const double least = arrow && !isEnd ? kRing : 0.0;
        const QSizeF size = sizeOf(text);
        for (const Wish &wish : {Wish{1.5, true}, Wish{1.0, true}, Wish{1.5, false}, Wish{1.0, false}}) {
            for (const double gap : kGaps) {
                for (const double turn : kTurns) {
                    const QRectF box =
                        boxAt(m_marks.texts[text].at, turned(way, turn), std::max(gap, least + 2.0), size);
                    if (isAsWished(text, box, wish))
                        return box;
                }
            }
        }
        return {};
    }

    QRectF placeWithLeader(std::size_t text) const
    {
        const QPointF &at = m_marks.texts[text].at;
        const HighlightMarks::Arrow *arrow = arrowOf(text);
        const QPointF way = arrow && arrow->tips == Tips::End
                                ? (arrow->line.p2() - arrow->line.p1()) / arrow->line.length()
                                : QPointF(0.0, 1.0);
        const QSizeF size = sizeOf(text);
        constexpr int kFirst = 20, kStep = 8, kLast = 120, kTurn = 15; // pixels and degrees
        for (const bool wantsAll : {true, false}) {
            for (int gap = kFirst; gap <= kLast; gap += kStep) {
                for (int turn = 0; turn <= 180; turn += kTurn) {
                    for (const double side : {1.0, -1.0}) {
                        const QRectF box = boxAt(at, turned(way, side * turn), gap, size);
                        if (isFree(box) && isLeaderFree(text, box, wantsAll) && (!wantsAll || isClear(box)))
                            return box;
                    }
                }
            }
        }
        return {};
    }
    /// @param isApart  it crosses no arrow, and the box is at no other tip
    bool isLeaderFree(std::size_t text, const QRectF &box, bool isApart) const
    {
        const std::optional<QLineF> leader = leaderOf(m_marks, text, box);
        if (!leader || std::any_of(m_taken.begin(), m_taken.end(), [&](const QRectF &one) {
                return !one.contains(leader->p1()) && areCrossed(one, *leader);
            }))
            return false;
        if (!isApart)
            return true;
        constexpr double kApart = 10.0, kOwn = 2.0;
        const bool isCrossed = std::any_of(m_lines.begin(), m_lines.end(), [&](const QLineF &line) {
            QPointF where;
            return line.intersects(*leader, &where) == QLineF::BoundedIntersection
                   && lengthOf(where - leader->p1()) > kOwn;
        });
        return !isCrossed
               && std::none_of(m_marks.texts.begin(), m_marks.texts.end(),
                               [&](const HighlightMarks::Text &other) { return distanceOf(box, other.at) < kApart; });
    }

    QRectF placeBesideLine(std::size_t text) const
    {
        const QLineF &line = arrowOf(text)->line;
        const QPointF way = (line.p2() - line.p1()) / line.length(), aside(-way.y(), way.x());
        const QSizeF size = sizeOf(text);
        for (const Wish &wish : {Wish{1.0, true, true}, Wish{1.0, true}, Wish{0.0, false}}) {
            for (const double gap : kGaps) {
                for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {
                    for (const double side : {1.0, -1.0}) {
                        const QRectF box = boxAt(line.pointAt(share), aside * side, gap, size);
                        if (isAsWished(text, box, wish))
                            return box;
                    }
                }
            }
        }
        return {};
    }

    const HighlightMarks &m_marks;
    QFont m_letter, m_index;
    QRectF m_area, m_middle;
    std::vector<QRectF> m_taken;
    std::vector<QLineF> m_lines; ///< that no letter may cover
};

} // namespace

QFont letterFont(QFont usual)
{
    usual.setBold(true);
    return usual;
}

QFont letterIndexFont(QFont letter)
{
    constexpr double kShare = 0.75;
    letter.setPixelSize(std::max(7, static_cast<int>(std::lround(letter.pixelSize() * kShare))));
    return letter;
}

std::optional<QLineF> leaderOf(const HighlightMarks &marks, std::size_t text, const QRectF &box)
{
    const HighlightMarks::Text &mine = marks.texts[text];
    if (box.isNull())
        return std::nullopt;
    constexpr double kMostGap = kGaps.back() + 1.0;
    const bool isLength = mine.arrow && gui::isLength(marks.arrows[*mine.arrow]);
    const QPointF to = nearestOf(box, mine.at), way = to - mine.at;
    if (isLength ? distanceOf(box, marks.arrows[*mine.arrow].line) < kMostGap
                 : std::max(std::abs(way.x()), std::abs(way.y())) < kMostGap)
        return std::nullopt;
    return QLineF(mine.at, to);
}

std::vector<QRectF> boxesOf(const HighlightMarks &marks, const QFont &font, const QRectF &area,
                            const std::vector<QRectF> &taken)
{
    Placer placer(marks, font, area, taken);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < marks.texts.size(); ++i) {
        if (area.contains(marks.texts[i].at))
            order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&placer](std::size_t a, std::size_t b) { return placer.roomOf(a) < placer.roomOf(b); });
    std::vector<QRectF> boxes(marks.texts.size());
    for (const std::size_t i : order)
        boxes[i] = placer.place(i);
    return boxes;
}

} // namespace unprojector::gui
