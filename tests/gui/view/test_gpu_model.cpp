// A model on its way into the graphics memory, which may take less than the model has.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "gui/view/frame_view.h"
#include "gui/view/painters/gpu_model.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::mesh;

namespace {

/// Red, its upper half blue.
std::shared_ptr<const Image> picture(int width, int height)
{
    auto image = std::make_shared<Image>(Image{width, height, {}});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool isUpper = 2 * y >= height;
            image->rgba.insert(image->rgba.end(),
                               {std::uint8_t(isUpper ? 0 : 255), 0, std::uint8_t(isUpper ? 255 : 0), 255});
        }
    }
    return image;
}

} // namespace

class TestGpuModel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_surface.setFormat(FrameView::preCreateWindow());
        m_surface.create();
        m_context.setFormat(FrameView::preCreateWindow());
        QVERIFY(m_context.create() && m_context.makeCurrent(&m_surface));
    }

    void aPictureThatIsTooLargeIsScaledDownAndSaid_data()
    {
        addColumn<QSize>("size");
        addColumn<int>("most");
        addColumn<QSize>("uploaded");
        int driver = 0;
        m_context.functions()->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &driver);
        newRow("small enough") << QSize(64, 32) << 64 << QSize(64, 32);
        newRow("too wide") << QSize(128, 64) << 64 << QSize(64, 32);
        newRow("too high") << QSize(64, 256) << 64 << QSize(16, 64);
        newRow("narrow") << QSize(256, 2) << 64 << QSize(64, 1);
        newRow("as large as the driver takes") << QSize(driver, 2) << 2 * driver << QSize(driver, 2);
        newRow("too wide for the driver") << QSize(driver + 2, 2) << 2 * driver << QSize(driver, 1);
    }

    void aPictureThatIsTooLargeIsScaledDownAndSaid()
    {
        QFETCH(QSize, size);
        QFETCH(int, most);
        QFETCH(QSize, uploaded);
        auto model = std::make_shared<Model>();
        model->meshes.push_back(examples::cubeMesh(1.0));
        model->textures.push_back({"folder/skin.png", {}, picture(size.width(), size.height()), true});
        GpuModel onGpu(model, most);
        QVERIFY(onGpu.uploadOn(Deadline({})));
        QOpenGLTexture &texture = onGpu.texture(0);
        QCOMPARE(QSize(texture.width(), texture.height()), uploaded);
        const QStringList said = onGpu.takeFailures();
        if (uploaded == size) {
            QCOMPARE(said, QStringList());
        } else {
            QCOMPARE(said.size(), 1);
            QVERIFY2(said[0].contains(QStringLiteral("skin.png"))
                         && said[0].contains(QStringLiteral("%1 pixels").arg(uploaded.width())),
                     qPrintable(said[0]));
        }
        QCOMPARE(m_context.functions()->glGetError(), GLenum(GL_NO_ERROR));
        // It is the same picture: read back, its corners have their colours.
        std::vector<std::uint8_t> read(std::size_t(4) * std::size_t(uploaded.width()) * std::size_t(uploaded.height()));
        GLuint framebuffer = 0;
        auto &gl = *m_context.extraFunctions();
        gl.glGenFramebuffers(1, &framebuffer);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.textureId(), 0);
        gl.glReadPixels(0, 0, uploaded.width(), uploaded.height(), GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        gl.glDeleteFramebuffers(1, &framebuffer);
        QCOMPARE(gl.glGetError(), GLenum(GL_NO_ERROR));
        if (uploaded.height() > 1) {
            QVERIFY(read[0] > 200 && read[2] < 50);
            QVERIFY(read[read.size() - 4] < 50 && read[read.size() - 2] > 200);
        }
    }

    void aBufferThatIsGoneWhenItIsFilledIsSaid()
    {
        auto model = std::make_shared<Model>();
        model->name = "large";
        Mesh &mesh = model->meshes.emplace_back();
        mesh.positions.resize(3'000'000, glm::vec3(1.0f)); // filled in parts
        GpuModel onGpu(model, 64);
        QVERIFY(!onGpu.uploadOn(Deadline(0)));
        QCOMPARE(onGpu.takeFailures(), QStringList());
        auto &gl = *m_context.extraFunctions();
        for (GLuint name = 1; name < 1000; ++name) {
            if (gl.glIsBuffer(name))
                gl.glDeleteBuffers(1, &name);
        }
        QVERIFY(onGpu.uploadOn(Deadline({})));
        const QStringList said = onGpu.takeFailures();
        QCOMPARE(said.size(), 1);
        QVERIFY2(said[0].contains(QStringLiteral("large")), qPrintable(said[0]));
    }

private:
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
};

UNPROJECTOR_TEST(TestGpuModel, display)
#include "test_gpu_model.moc"
