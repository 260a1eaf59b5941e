#include "gui/text/error_text.h"

#include "core/base/path_text.h"
#include "core/geometry/error_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>
#include <QTextDocument>

#include <utility>

namespace unprojector::gui {
using namespace geometry;
namespace {

struct Errors {
    Q_DECLARE_TR_FUNCTIONS(Errors)
};

constexpr auto kModelSuffixes = "*.obj *.stl *.ply *.off *.gltf *.glb";

} // namespace

QString pathText(const std::filesystem::path &path)
{
#ifdef _WIN32
    return QDir::toNativeSeparators(QString::fromStdWString(path.wstring()));
#else
    return QString::fromLocal8Bit(path.string().c_str());
#endif
}

QString plainToolTip(const QString &text)
{
    return text.isEmpty() ? text : Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal);
}

QString modelFileFilter()
{
    return Errors::tr("Models (%1)").arg(QLatin1String(kModelSuffixes));
}

QString openableFileFilter()
{
    return Errors::tr("Models and scenes (%1)").arg(QLatin1String(kModelSuffixes) + QStringLiteral(" *.json"));
}

QString errorText(const geometry::Error &error)
{
    static const QRegularExpression size(QStringLiteral("(?<=\\d) x (?=[-\\d])"));
    return sentence(geometry::errorText(error)).replace(size, QStringLiteral(" × "));
}

QString errorText(const base::ExpressionError &error, const QString &typed)
{
    constexpr int kMostShownCharacters = 24;
    const std::string bytes = typed.toStdString();
    const QString part = QString::fromStdString(bytes.substr(error.place, error.length));
    const auto place = QString::fromStdString(bytes.substr(0, error.place)).size() + 1;
    const auto shortened = [](const QString &text) {
        return text.size() > kMostShownCharacters ? text.left(kMostShownCharacters) + u'…' : text;
    };
    const QString all = shortened(typed.trimmed());
    using Code = base::ExpressionErrorCode;
    switch (error.code) {
    case Code::Empty: return Errors::tr("The field is empty. Type a number.");
    case Code::MissingNumber:
        return part.isEmpty() ? Errors::tr("“%1” ends where a number is expected. Complete it.").arg(all)
                              : Errors::tr("“%1”: a number is missing before “%2” (character %3).")
                                    .arg(all, shortened(part))
                                    .arg(place);
    case Code::MissingOperator:
        return Errors::tr("“%1”: a sign such as * or + is missing before “%2” (character %3).")
            .arg(all, shortened(part))
            .arg(place);
    case Code::AmbiguousComma:
        return Errors::tr("“%1” can be read in two ways: type %2 or %3.")
            .arg(all, QString(typed).remove(u',').trimmed(), QString(typed).replace(u',', u'.').trimmed());
    case Code::SecondPoint:
        return Errors::tr("“%1” has a second decimal point (character %2); write thousands without a comma.")
            .arg(all)
            .arg(place);
    case Code::UnknownName:
        return Errors::tr("“%1” is not a number; type one such as 0.5, 1e-3, 1/3 or 2*pi.").arg(shortened(part));
    case Code::UnknownCharacter:
        return Errors::tr("“%1”: “%2” (character %3) is not allowed here; use + - * / and parentheses.")
            .arg(all, part)
            .arg(place);
    case Code::NotCalled: return Errors::tr("%1 needs its number in parentheses: %1(2).").arg(part);
    case Code::UnclosedParenthesis:
        return Errors::tr("“%1”: the parenthesis at character %2 is not closed.").arg(all).arg(place);
    case Code::UnopenedParenthesis:
        return Errors::tr("“%1”: the parenthesis at character %2 was never opened.").arg(all).arg(place);
    case Code::DivisionByZero: return Errors::tr("“%1” divides by 0 (character %2).").arg(all).arg(place);
    case Code::RootOfNegative: return Errors::tr("“%1” takes the root of a negative number.").arg(all);
    case Code::OutOfRange: return Errors::tr("%1 is too large or too small for a number here.").arg(shortened(part));
    case Code::TooDeep: return Errors::tr("“%1” nests too many parentheses. Use fewer.").arg(all);
    }
    Q_UNREACHABLE();
}

QString errorText(base::Error error)
{
    const QString file = pathText(base::pathFromUtf8(std::exchange(error.file, {})));
    if (error.line > 0)
        error.file = file.toStdString();
    const QString text = ended(error.message());
    return file.isEmpty() || error.line > 0 ? text
                                            : Errors::tr("%1: %2", "a file: the message about it").arg(file, text);
}

} // namespace unprojector::gui
