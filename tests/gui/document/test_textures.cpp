// Textures of models: decoded by the loader, scaled down if too large, and never left out silently.

#include "tests/support/test.h"

#include "gui/document/texture_decoding.h"
#include "gui/text/note_text.h"

#include <QBuffer>
#include <QImage>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::mesh;

namespace {

std::vector<std::uint8_t> encoded(const QImage &image, const char *format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return {bytes.begin(), bytes.end()};
}

Model modelWith(std::vector<std::uint8_t> bytes)
{
    Model model;
    model.textures.push_back({"skin.png", std::move(bytes), nullptr, true});
    return model;
}

QImage picture(int width, int height)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::red);
    image.setPixelColor(0, height - 1, Qt::blue);
    return image;
}

} // namespace

class TestTextures : public QObject {
    Q_OBJECT

private slots:
    void picturesAreDecoded_data()
    {
        addColumn<QByteArray>("format");
        newRow("PNG") << QByteArray("PNG");
        newRow("BMP") << QByteArray("BMP");
        newRow("PPM, as embedded texels come") << QByteArray("PPM");
    }

    void picturesAreDecoded()
    {
        QFETCH(QByteArray, format);
        Model model = modelWith(encoded(picture(3, 2), format));
        decodeTextures(model, [] { return true; });
        QVERIFY(model.notes.empty());
        const Texture &texture = model.textures.front();
        QVERIFY(texture.image && texture.encoded.empty());
        QCOMPARE(texture.image->widthPixels, 3);
        QCOMPARE(texture.image->heightPixels, 2);
        // The first row is the bottom one: it begins blue, and red follows.
        const std::vector<std::uint8_t> first(texture.image->rgba.begin(), texture.image->rgba.begin() + 8);
        QCOMPARE(first, (std::vector<std::uint8_t>{0, 0, 255, 255, 255, 0, 0, 255}));
    }

    void whatIsTooLargeIsScaledDownAndSaid()
    {
        Model model = modelWith(encoded(picture(kMostTexturePixels + 808, 9), "PNG"));
        decodeTextures(model, [] { return true; });
        const Texture &texture = model.textures.front();
        QVERIFY(texture.image);
        QCOMPARE(texture.image->widthPixels, kMostTexturePixels);
        QCOMPARE(texture.image->heightPixels, 8);
        QCOMPARE(model.notes.size(), std::size_t(1));
        QCOMPARE(model.notes.front().text(), "the image \"skin.png\" is too large and is shown with a width of "
                                                 + std::to_string(kMostTexturePixels) + " pixels");
    }

    void whatCannotBeDecodedIsSaid_data()
    {
        addColumn<QByteArray>("bytes");
        newRow("no picture") << QByteArray("hello");
        const std::vector<std::uint8_t> whole = encoded(picture(64, 64), "PNG");
        newRow("cut off") << QByteArray(reinterpret_cast<const char *>(whole.data()), 60);
        newRow("a header of 100,000 by 100,000 pixels") << QByteArray("P6\n100000 100000\n255\n");
    }

    void whatCannotBeDecodedIsSaid()
    {
        QFETCH(QByteArray, bytes);
        Model model = modelWith({bytes.begin(), bytes.end()});
        decodeTextures(model, [] { return true; });
        QVERIFY(!model.textures.front().image);
        QVERIFY(notesText(QStringLiteral("head.obj"), {}).isEmpty());
        QVERIFY(notesText(QStringLiteral("head.obj"), model.notes)
                    .startsWith(QStringLiteral("head.obj: The image \"skin.png\" is damaged")));
    }

    void theLoadingCanBeCancelled()
    {
        Model model = modelWith(encoded(picture(3, 2), "PNG"));
        decodeTextures(model, [] { return false; });
        QVERIFY(!model.textures.front().image);
        QVERIFY(model.notes.empty());
    }
};

UNPROJECTOR_TEST(TestTextures)
#include "test_textures.moc"
