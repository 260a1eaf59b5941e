#pragma once

#include "core/doctor/mistakes.h"
#include "core/doctor/written_value.h"

#include <QRegularExpression>
#include <QString>
#include <QStringList>

/// The doctor's lines of code and the values in them.
namespace doctor_lines {

/// A candidate's lines for a library, with its values.
inline QString linesOf(const unprojector::doctor::Candidate &candidate, std::string_view library)
{
    QString lines;
    for (const auto &change : codeOf(candidate.id, candidate.values)) {
        if (change.library == library)
            lines += QString::fromStdString(change.wrong + '\n' + change.right + '\n');
    }
    return lines;
}

inline bool hasWord(const QString &lines, const QString &word)
{
    const QString pattern = QStringLiteral("(?<![\\w.])%1(?![\\w.])").arg(QRegularExpression::escape(word));
    return lines.contains(QRegularExpression(pattern));
}

/// The values that lines of the candidate's one mistake lack, and the names that no value fills. The
/// values `as` and `about` choose the lines and stand in none.
inline QString faultsOf(const unprojector::doctor::Candidate &candidate)
{
    QStringList faults;
    for (const std::string_view library : {"GLU", "GLM", "Qt", "three.js", "NumPy"}) {
        const QString lines = linesOf(candidate, library);
        const QString title = QString::fromStdString(candidate.id + ", " + std::string(library) + ": ");
        static const QRegularExpression unfilled(QStringLiteral("\\bother_?[A-Za-z]*"));
        if (lines.contains(unfilled))
            faults << title + unfilled.match(lines).captured();
        for (const unprojector::doctor::SolvedValue &value : candidate.values) {
            if (lines.isEmpty() || value.name == "as" || value.name == "about")
                continue;
            if (!value.word.empty() && !lines.contains(QString::fromStdString(value.word)))
                faults << title + QString::fromStdString(value.name);
            for (const double number : value.numbers) {
                if (!hasWord(lines, QString::fromStdString(unprojector::doctor::valueText(number))))
                    faults << title + QString::fromStdString(value.name);
            }
        }
    }
    return faults.join(QStringLiteral("; "));
}

/// The faults of all candidates that have values.
inline QString faultsOf(const unprojector::doctor::Diagnosis &diagnosis)
{
    QStringList faults;
    for (const unprojector::doctor::Candidate &candidate : diagnosis.candidates) {
        if (!candidate.values.empty() && candidate.id.find('+') == std::string::npos) {
            if (const QString found = faultsOf(candidate); !found.isEmpty())
                faults << found;
        }
    }
    return faults.join(QStringLiteral("; "));
}

} // namespace doctor_lines
