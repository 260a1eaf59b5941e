// The main function of a folder's test program.

#include "tests/support/test.h"

#include <QRegularExpression>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using Application = QApplication;
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
using Application = QGuiApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

namespace {

std::map<QString, std::function<int(const QStringList &)>> &helpers()
{
    static std::map<QString, std::function<int(const QStringList &)>> all;
    return all;
}

/// "unprojector::gui::TestPickStrip" is test_pick_strip.
QString nameOf(const tests::Class &test)
{
    static const QRegularExpression inner(QStringLiteral("(?<=[a-z0-9])(?=[A-Z])"));
    return QString::fromLatin1(test.meta->className()).section(u':', -1).replace(inner, QStringLiteral("_")).toLower();
}

} // namespace

namespace tests {

std::vector<Class> &classes()
{
    static std::vector<Class> all;
    return all;
}

Helper::Helper(const QString &name, std::function<int(const QStringList &words)> run)
{
    helpers()[QStringLiteral("--") + name] = std::move(run);
}

} // namespace tests

int main(int argc, char **argv)
{
#if !defined(QT_WIDGETS_LIB) && !defined(Q_OS_WIN)
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // it shows nothing
#endif
#ifdef QT_WIDGETS_LIB
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // a test finds its way about Qt's own
#endif
    const Application application(argc, argv);
    QStringList words = QCoreApplication::arguments();
    const QString first = words.value(1);
    if (const auto helper = helpers().find(first); helper != helpers().end())
        return helper->second(words.mid(2));
    std::vector<tests::Class> chosen = tests::classes();
    std::sort(chosen.begin(), chosen.end(), [](const auto &a, const auto &b) { return nameOf(a) < nameOf(b); });
    if (!first.isEmpty() && !first.startsWith(u'-')) {
        std::erase_if(chosen, [&first](const tests::Class &test) { return nameOf(test) != first; });
        if (chosen.empty()) {
            std::fprintf(stderr, "There is no test %s. There are:\n", qPrintable(first));
            for (const tests::Class &test : tests::classes())
                std::fprintf(stderr, "  %s\n", qPrintable(nameOf(test)));
            return 2;
        }
        words.removeAt(1);
    }
    int failed = 0;
    for (const tests::Class &test : chosen)
        failed += QTest::qExec(test.make().get(), words);
    return std::min(failed, 127);
}
