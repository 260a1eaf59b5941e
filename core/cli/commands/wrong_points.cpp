#include "core/cli/commands/wrong_points.h"

#include "core/base/translation.h"
#include "core/cli/rows/byte_stream.h"
#include "core/doctor/written_points.h"

#include <array>
#include <cstddef>
#include <utility>

namespace unprojector::cli {
using namespace geometry;
using namespace doctor;
using base::tr;
namespace {

std::optional<std::string> allOf(ByteSource &source)
{
    std::string text;
    std::array<char, 16384> buffer;
    for (std::size_t size = 1; size > 0 && text.size() <= kMostPointBytes;) {
        size = source.read(buffer.data(), buffer.size());
        text.append(buffer.data(), size);
    }
    if (source.hasFailed()) {
        complain(tr("%1: cannot be read", source.name()));
        return std::nullopt;
    }
    if (text.size() > kMostPointBytes) {
        complain(tr("%1: larger than %2 MB; give only the points to check, of which the first %3 are used",
                    source.name(), kMostPointBytes >> 20, kMostWrongPoints));
        return std::nullopt;
    }
    return text;
}

std::string tableErrorText(const PointTableError &error)
{
    const std::string column(error.column);
    switch (error.kind) {
    case PointTableError::Kind::NoColumn:
        return tr("there is no column \"%1\"; give px,py,depth,x,y,z, where depth may be left out", column);
    case PointTableError::Kind::DoubledColumn:
        return tr("the column \"%1\" is there twice; leave one of them out", column);
    case PointTableError::Kind::OpenQuote: return tr("a quote is opened here and not closed at the end of its cell");
    }
    return {};
}

std::string rowErrorText(const PointRow &row, std::size_t index)
{
    if (index >= kPointColumns.size())
        return tr("the row has more than six cells; give px,py,depth,x,y,z, with a point for the decimals");
    return std::string(kPointColumns[index]) + ": " + tr("\"%1\" is not a number", row.cells[index]);
}

} // namespace

std::optional<WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth, const std::string &got)
{
    auto point = wrongPointOf(pixel, depth, got, {"--pixel", "--depth", "--got"});
    if (point)
        return std::move(point).value();
    complain(point.error());
    return std::nullopt;
}

std::optional<WrongPoints> wrongPoints(const std::string &file)
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    const std::optional<std::string> text = allOf(source);
    if (!text)
        return std::nullopt;
    const auto where = [&](std::size_t line) { return source.name() + ':' + std::to_string(line) + ": "; };
    const Result<std::vector<PointRow>, PointTableError> rows = pointRows(*text);
    if (!rows) {
        complain(where(rows.error().line) + tableErrorText(rows.error()));
        return std::nullopt;
    }
    WrongPoints result;
    std::size_t surplus = 0;
    for (const PointRow &row : *rows) {
        if (result.points.size() == kMostWrongPoints) {
            ++surplus;
            continue;
        }
        if (const auto point = pointOf(row)) {
            result.points.push_back(*point);
            result.names.push_back(source.name() + ':' + std::to_string(row.line));
        } else {
            complain(where(row.line) + rowErrorText(row, point.error()));
            result.isComplete = false;
        }
    }
    if (surplus > 0)
        complain(tr(surplus == 1 ? "%1: the first %2 points are used; %3 more is ignored"
                                 : "%1: the first %2 points are used; %3 more are ignored",
                    source.name(), kMostWrongPoints, surplus));
    if (result.points.empty()) {
        complain(tr("%1: there is no point in it; give rows of px,py,depth,x,y,z", source.name()));
        return std::nullopt;
    }
    return result;
}

} // namespace unprojector::cli
