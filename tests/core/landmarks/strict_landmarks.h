#pragma once

#include "core/landmark_files/landmark_file.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QList>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QXmlStreamReader>

/// Readers that share nothing with ours and forgive nothing, for the tests of landmark files.
namespace strict_landmarks {

inline QStringList noteTexts(const std::vector<unprojector::base::Note> &notes)
{
    QStringList texts;
    for (const unprojector::base::Note &note : notes)
        texts << QString::fromStdString(note.text());
    return texts;
}

/// The number that a strict reader finds; an invalid one ends the test.
inline double strictNumber(const QByteArray &text)
{
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    if (!isNumber || text.contains(' ') || (text.contains('+') && !text.contains("e+")))
        qFatal("\"%s\" is not a number", text.constData());
    return value;
}

/// A point as the strict readers find it.
struct StrictPoint {
    QString name;
    bool isMissing = false;
    glm::dvec3 place{0.0};
};

inline glm::dvec3 strictPlace(const QList<QByteArray> &words)
{
    return {strictNumber(words.at(0)), strictNumber(words.at(1)), strictNumber(words.at(2))};
}

/// A parser of RFC 4180 and nothing else.
inline QList<QList<QByteArray>> strictCsv(const QByteArray &text)
{
    QList<QList<QByteArray>> rows(1);
    QByteArray cell;
    bool isQuoted = false;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (isQuoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"')
            cell += text[++i];
        else if (text[i] == '"')
            isQuoted = !isQuoted;
        else if (!isQuoted && (text[i] == ',' || text[i] == '\n')) {
            rows.back() << cell;
            cell.clear();
            if (text[i] == '\n')
                rows << QList<QByteArray>();
        } else
            cell += text[i];
    }
    if (isQuoted || !rows.takeLast().isEmpty())
        qFatal("the table does not end with a line");
    for (const auto &row : rows) {
        if (row.size() != rows.front().size())
            qFatal("a row has %d cells", int(row.size()));
    }
    return rows;
}

inline QList<StrictPoint> strictPoints(const QByteArray &text, unprojector::landmark_files::Format format)
{
    QList<StrictPoint> points;
    const QList<QByteArray> lines = text.split('\n');
    const auto at = [&](int i) { return lines.at(i); };
    switch (format) {
    case unprojector::landmark_files::Format::Csv: {
        const auto rows = strictCsv(text);
        const auto column = [&](const char *name) { return rows.front().indexOf(name); };
        for (const auto &row : rows.mid(1)) {
            StrictPoint point{QString::fromUtf8(row.at(column("name"))), row.at(column("x")).isEmpty(), {}};
            if (!point.isMissing)
                point.place = strictPlace({row.at(column("x")), row.at(column("y")), row.at(column("z"))});
            points << point;
        }
        break;
    }
    case unprojector::landmark_files::Format::MeshLab:
    case unprojector::landmark_files::Format::MeshLabTemplate: {
        QXmlStreamReader xml(text);
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::DTD
                && xml.dtdName()
                       != QLatin1String(format == unprojector::landmark_files::Format::MeshLab ? "PickedPoints"
                                                                                               : "PickPointsTemplate"))
                qFatal("another document");
            if (!xml.isStartElement() || xml.name() != QLatin1String("point"))
                continue;
            const auto value = [&](const char *name) { return xml.attributes().value(QLatin1String(name)).toUtf8(); };
            StrictPoint point{xml.attributes().value(QLatin1String("name")).toString(), value("active") != "1", {}};
            if (format == unprojector::landmark_files::Format::MeshLab) {
                point.place = strictPlace({value("x"), value("y"), value("z")});
                if ((value("x") + value("y") + value("z")).contains('e'))
                    qFatal("an exponent, whose letter R's Morpho strips");
            }
            points << point;
        }
        if (xml.hasError())
            qFatal("%s", qPrintable(xml.errorString()));
        break;
    }
    case unprojector::landmark_files::Format::SlicerJson: {
        const QJsonObject document = QJsonDocument::fromJson(text).object();
        if (!document["@schema"].toString().contains("markups-schema-v1"))
            qFatal("3D Slicer takes no file without a schema");
        const QJsonObject markup = document["markups"].toArray().at(0).toObject();
        const double sign = markup["coordinateSystem"] == "LPS" ? 1 : -1;
        QSet<QString> ids;
        for (const QJsonValue value : markup["controlPoints"].toArray()) {
            const QJsonArray place = value["position"].toArray();
            if (place.size() != 3 || value["orientation"].toArray().size() != 9 || !value["visibility"].isBool()
                || !value["selected"].isBool() || !value["locked"].isBool() || ids.contains(value["id"].toString()))
                qFatal("a point is incomplete");
            ids << value["id"].toString();
            points << StrictPoint{value["label"].toString(),
                                  value["positionStatus"] != "defined",
                                  {sign * place[0].toDouble(), sign * place[1].toDouble(), place[2].toDouble()}};
        }
        break;
    }
    case unprojector::landmark_files::Format::SlicerCsv: {
        if (at(0) != "# Markups fiducial file version = 5.8" || !at(1).startsWith("# CoordinateSystem = ")
            || at(2) != "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID")
            qFatal("another header");
        if (text.count('#') != 3)
            qFatal("readers count the lines that hold #");
        const double sign = at(1).endsWith("LPS") ? 1 : -1;
        for (const auto &row : strictCsv(text.mid(text.indexOf("NodeID\n") + 7))) {
            if (row.size() != 16 || (row[14] != "0" && row[14] != "2" && row[14] != "3") || row[15].size() != 1)
                qFatal("a row has %d cells", int(row.size()));
            const glm::dvec3 place = strictPlace(row.mid(1, 3));
            points << StrictPoint{
                QString::fromUtf8(row[11]), row[14] != "2", {sign * place.x, sign * place.y, place.z}};
        }
        break;
    }
    case unprojector::landmark_files::Format::Idav: {
        if (at(0) != "Version 1.0" || !text.endsWith("\n\n") || lines.size() != at(1).toInt() + 4)
            qFatal("the header or the end is wrong");
        for (int i = 2; i < lines.size() - 2; ++i) {
            const QList<QByteArray> words = at(i).split(' ');
            if (words.size() != 4)
                qFatal("a line of %d words", int(words.size()));
            points << StrictPoint{QString::fromUtf8(words[0]),
                                  words.mid(1) == QList<QByteArray>{"9999", "9999", "9999"}, strictPlace(words.mid(1))};
        }
        break;
    }
    case unprojector::landmark_files::Format::Tps: {
        const int count = at(0).mid(4).toInt();
        if (!at(0).startsWith("LM3=") || !text.endsWith("\n\n") || text.contains("SCALE"))
            qFatal("the header or the end is wrong");
        for (int i = 1; i <= count; ++i) {
            const bool isMissing = at(i) == "NA NA NA";
            points << StrictPoint{{}, isMissing, isMissing ? glm::dvec3(0.0) : strictPlace(at(i).split(' '))};
        }
        break;
    }
    case unprojector::landmark_files::Format::Nts:
    case unprojector::landmark_files::Format::LandmarkAscii:
    case unprojector::landmark_files::Format::Landmarker: break;
    }
    return points;
}

} // namespace strict_landmarks

Q_DECLARE_METATYPE(unprojector::landmark_files::Format)
