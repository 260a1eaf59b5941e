// Files that a model refers to: those outside its folder are read, and named.

#include "tests/support/test.h"

#include "tests/core/mesh/imported.h"

#include <filesystem>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace model_files;

class TestFilesElsewhere : public QObject {
    Q_OBJECT

private slots:
    /// The folder above the model's replaces %1 in the texts.
    void areNamed_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<QByteArray>("notes");
        const auto gltf = [](const char *row, const char *buffer, const char *picture, const char *notes) {
            newRow(row) << "box.gltf" << gltfJson(buffer, {}, "\"uri\":\"" + QByteArray(picture) + '"')
                        << QByteArray(notes);
        };
        gltf("glTF, beside the model", "box.bin", "skin.png", "");
        gltf("glTF, below it", "parts/box.bin", "./parts/../parts/skin.png", "");
        gltf("glTF, out and in again", "../model/box.bin", "skin.png", "");
        gltf("glTF, a picture in a folder beside it", "box.bin", "../textures/skin.png",
             "the file \"../textures/skin.png\" outside the model's folder was read");
        gltf("glTF, both", "../textures/box.bin", "../textures/skin.png",
             "the file \"../textures/box.bin\" and 1 other one outside the model's folder were read");
        gltf("glTF, an absolute path", "box.bin", "%1/textures/skin.png",
             "the file \"%1/textures/skin.png\" outside the model's folder was read");
        gltf("glTF, an absolute path to the model's folder", "%1/model/box.bin", "skin.png", "");

        const QByteArray used = objBox("vt 0 0\nusemtl skin\n", "/1");
        newRow("OBJ, beside the model") << "box.obj"
                                        << "mtllib skin.mtl\n" + used << QByteArray();
        newRow("OBJ, materials and their picture")
            << "box.obj"
            << "mtllib ../textures/far.mtl\n" + used
            << QByteArray("the file \"../textures/far.mtl\" and 1 other one outside the model's folder were read");
        newRow("OBJ, the same materials twice")
            << "box.obj"
            << "mtllib ../textures/skin.mtl\nmtllib ../textures/skin.mtl\n" + used
            << QByteArray("the file \"../textures/skin.mtl\" outside the model's folder was read");
        newRow("OBJ, an absolute path") << "box.obj"
                                        << "mtllib %1/textures/skin.mtl\n" + used
                                        << QByteArray(
                                               "the file \"%1/textures/skin.mtl\" outside the model's folder was read");
        newRow("PLY") << "box.ply"
                      << plyText("comment TextureFile ../textures/skin.png\n", "property float s\nproperty float t\n",
                                 " 0 0")
                      << QByteArray("the file \"../textures/skin.png\" outside the model's folder was read");
    }

    void areNamed()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, notes);
        const ImportFolder all;
        const QByteArray root = QByteArray::fromStdString(all.path().generic_string());
        for (const char *folder : {"model", "model/parts", "textures"}) {
            std::filesystem::create_directory(all.path() / folder);
            const QString prefix = QString::fromLatin1(folder) + u'/';
            all.write(prefix + "box.bin", gltfBuffer());
            all.write(prefix + "skin.png", kPicture);
            all.write(prefix + "skin.mtl", "newmtl skin\nmap_Kd skin.png\n");
            all.write(prefix + "far.mtl", "newmtl skin\nmap_Kd ../textures/skin.png\n");
        }
        const auto result = all.imported("model/" + name, content.replace("%1", root));
        VERIFY_BOX_WITH_NOTES(result, notes.replace("%1", root));
    }
};

UNPROJECTOR_TEST(TestFilesElsewhere, threads)
#include "test_files_elsewhere.moc"
