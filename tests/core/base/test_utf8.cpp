// Texts of files in other encodings.

#include "tests/support/test.h"

#include "core/base/utf8.h"

#include <string>

using namespace unprojector::base;

class TestUtf8 : public QObject {
    Q_OBJECT

private slots:
    void aFileHasItsLettersAndNoMore_data()
    {
        addColumn<std::string>("file");
        addColumn<std::string>("text");
        const std::string letters = "0123456789 0123456789 0123456789 é";
        std::string little = "\xff\xfe", big = "\xfe\xff";
        for (const QChar c : QString::fromStdString(letters)) {
            little += {static_cast<char>(c.unicode() & 0xff), static_cast<char>(c.unicode() >> 8)};
            big += {static_cast<char>(c.unicode() >> 8), static_cast<char>(c.unicode() & 0xff)};
        }
        newRow("UTF-8") << letters << letters;
        newRow("UTF-16, little-endian") << little << letters;
        newRow("UTF-16, big-endian") << big << letters;
        newRow("half a letter") << little + 'a' << letters + "\xef\xbf\xbd";
        newRow("no letters") << std::string("\xff\xfe") << std::string();
    }

    void aFileHasItsLettersAndNoMore()
    {
        QFETCH(std::string, file);
        QFETCH(std::string, text);
        QCOMPARE(utf8FromFile(file), text);
    }
};

UNPROJECTOR_TEST(TestUtf8)
#include "test_utf8.moc"
