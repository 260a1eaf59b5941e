#include "core/geometry/finite.h"
#include "core/mesh_import/assimp_files.h"
#include "core/mesh_import/mesh_reader.h"

#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <string>
#include <string_view>
#include <utility>

namespace unprojector::mesh_import::mesh_reader {

namespace {

constexpr std::size_t kVerticesBetweenReports = 1 << 16;

glm::dmat4 fromAssimp(const aiMatrix4x4 &m)
{
    // aiMatrix4x4 names its elements by row, GLM stores columns.
    return {{m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}};
}

std::uint8_t byteFromShare(float share)
{
    // Written so that NaN becomes 0.
    return share > 0.0f ? static_cast<std::uint8_t>(std::lround(std::min(share, 1.0f) * 255.0f)) : std::uint8_t{0};
}

/// An uncompressed embedded picture as a binary PPM, which any decoder reads; PPM has no alpha.
std::vector<std::uint8_t> ppmFromTexels(const aiTexture &texture)
{
    const std::string header =
        "P6\n" + std::to_string(texture.mWidth) + ' ' + std::to_string(texture.mHeight) + "\n255\n";
    std::vector<std::uint8_t> ppm(header.begin(), header.end());
    const std::size_t count = std::size_t{texture.mWidth} * texture.mHeight;
    ppm.reserve(ppm.size() + 3 * count);
    for (std::size_t i = 0; i < count; ++i)
        ppm.insert(ppm.end(), {texture.pcData[i].r, texture.pcData[i].g, texture.pcData[i].b});
    return ppm;
}

/// How a mesh of one material looks.
struct Look {
    glm::vec4 baseColor{0.8f, 0.8f, 0.8f, 1.0f};
    bool hasBaseColor = false; ///< whether the file says so
    int texture = -1;
    unsigned texcoordSet = 0;
};

/// Turns an aiScene into a Model.
class SceneConverter {
public:
    SceneConverter(const aiScene &scene, const Source &source) : m_scene(scene), m_source(source) {}

    Model convert()
    {
        for (unsigned m = 0; m < m_scene.mNumMaterials; ++m)
            m_looks.push_back(lookOf(*m_scene.mMaterials[m]));
        for (unsigned m = 0; m < m_scene.mNumMeshes; ++m)
            m_totalVertices += m_scene.mMeshes[m]->mNumVertices;
        if (m_scene.mRootNode)
            addNode(*m_scene.mRootNode, glm::dmat4(1.0));
        for (auto &[key, mesh] : m_meshes) {
            if (!mesh.indices.empty())
                m_model.meshes.push_back(std::move(mesh));
        }
        return std::move(m_model);
    }

private:
    /// Meshes of one material become one, where they carry the same kinds of attributes.
    struct Key {
        unsigned material;
        bool hasNormals;
        bool hasColors;
        bool hasTexcoords;
        // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in what the compiler writes here
        auto operator<=>(const Key &) const = default;
    };

    Look lookOf(const aiMaterial &material)
    {
        Look look;
        aiString name;
        material.Get(AI_MATKEY_NAME, name);
        aiColor4D color;
        // assimp invents a material, and a colour for it, where the file has none.
        if (std::string(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME
            && (material.Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS
                || material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS)) {
            look.baseColor = {color.r, color.g, color.b, color.a};
            look.hasBaseColor = true;
        }
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
            aiString path;
            aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
            if (material.GetTexture(type, 0, &path, nullptr, &look.texcoordSet, nullptr, nullptr, modes)
                != aiReturn_SUCCESS)
                continue;
            look.texture = textureNumber(path.C_Str(), modes[0] != aiTextureMapMode_Clamp);
            // Some programs write black beside a picture and mean the picture alone.
            if (!look.hasBaseColor || glm::vec3(look.baseColor) == glm::vec3(0.0f))
                look.baseColor = glm::vec4(1.0f, 1.0f, 1.0f, look.baseColor.a);
            look.hasBaseColor = true;
            break;
        }
        return look;
    }

    int textureNumber(const std::string &path, bool wrapRepeat)
    {
        const auto [known, isNew] =
            m_textureNumbers.try_emplace({path, wrapRepeat}, static_cast<int>(m_model.textures.size()));
        if (!isNew)
            return known->second;
        Texture texture;
        if (const aiTexture *embedded = m_scene.GetEmbeddedTexture(path.c_str())) {
            texture.file = m_source.file;
            if (embedded->mHeight == 0) {
                const auto *bytes = reinterpret_cast<const std::uint8_t *>(embedded->pcData);
                texture.encoded.assign(bytes, bytes + embedded->mWidth);
            } else {
                texture.encoded = ppmFromTexels(*embedded);
            }
        } else {
            texture = readTexture(m_source.file, path);
        }
        texture.wrapRepeat = wrapRepeat;
        m_model.textures.push_back(std::move(texture));
        return known->second;
    }

    void addNode(const aiNode &node, const glm::dmat4 &worldFromParent)
    {
        const glm::dmat4 worldFromNode = worldFromParent * fromAssimp(node.mTransformation);
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            addMesh(*m_scene.mMeshes[node.mMeshes[m]], worldFromNode);
        for (unsigned c = 0; c < node.mNumChildren; ++c)
            addNode(*node.mChildren[c], worldFromNode);
    }

    void addMesh(const aiMesh &mesh, const glm::dmat4 &worldFromMesh)
    {
        if (!(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) || mesh.mMaterialIndex >= m_looks.size())
            return;
        const Look &look = m_looks[mesh.mMaterialIndex];
        const bool hasTexcoords = look.texture >= 0 && look.texcoordSet < AI_MAX_NUMBER_OF_TEXTURECOORDS
                                  && mesh.HasTextureCoords(look.texcoordSet);
        Mesh &target = m_meshes[{mesh.mMaterialIndex, mesh.HasNormals(), mesh.HasVertexColors(0), hasTexcoords}];
        target.texture = hasTexcoords ? look.texture : -1;
        target.baseColor = !look.hasBaseColor && mesh.HasVertexColors(0) ? glm::vec4(1.0f) : look.baseColor;

        const auto first = static_cast<std::uint32_t>(target.positions.size());
        const bool isIdentity = worldFromMesh == glm::dmat4(1.0);
        const glm::dmat3 linear(worldFromMesh);
        // The cofactor matrix: inverse transpose times determinant, which a flat scale does not make infinite.
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        const bool isMirrored = glm::determinant(linear) < 0.0;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            if (v % kVerticesBetweenReports == 0)
                m_source.progress.report(0.7
                                         + 0.3 * static_cast<double>(m_doneVertices + v)
                                               / static_cast<double>(std::max<std::size_t>(m_totalVertices, 1)));
            const glm::vec3 position(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
            if (!isFinite(position))
                throw Failure(ImportErrorCode::NotFinite, {}, m_doneVertices + v);
            target.positions.push_back(isIdentity ? position
                                                  : glm::vec3(worldFromMesh * glm::dvec4(glm::dvec3(position), 1.0)));
            if (mesh.HasNormals()) {
                glm::vec3 normal(mesh.mNormals[v].x, mesh.mNormals[v].y, mesh.mNormals[v].z);
                if (!isIdentity) {
                    const glm::dvec3 turned = cofactors * glm::dvec3(normal) * (isMirrored ? -1.0 : 1.0);
                    const double length = glm::length(turned);
                    normal = length > 0.0 ? glm::vec3(turned / length) : glm::vec3(0.0f);
                }
                target.normals.push_back(normal);
            }
            if (mesh.HasVertexColors(0)) {
                const aiColor4D &color = mesh.mColors[0][v];
                target.colors.emplace_back(byteFromShare(color.r), byteFromShare(color.g), byteFromShare(color.b),
                                           byteFromShare(color.a));
            }
            if (hasTexcoords) {
                const aiVector3D &texcoord = mesh.mTextureCoords[look.texcoordSet][v];
                target.texcoords.emplace_back(texcoord.x, texcoord.y);
            }
        }
        target.indices.reserve(target.indices.size() + 3 * std::size_t{mesh.mNumFaces});
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace &face = mesh.mFaces[f];
            if (face.mNumIndices != 3)
                continue;
            for (unsigned corner = 0; corner < 3; ++corner) {
                if (face.mIndices[corner] >= mesh.mNumVertices)
                    failMalformed("a face refers to vertex " + std::to_string(face.mIndices[corner]) + ", the mesh has "
                                  + std::to_string(mesh.mNumVertices) + " (counted from 0)");
            }
            target.indices.insert(target.indices.end(),
                                  {first + face.mIndices[0], first + face.mIndices[isMirrored ? 2 : 1],
                                   first + face.mIndices[isMirrored ? 1 : 2]});
        }
        m_doneVertices += mesh.mNumVertices;
    }

    const aiScene &m_scene;
    const Source &m_source;
    Model m_model;
    std::vector<Look> m_looks;
    std::map<std::pair<std::string, bool>, int> m_textureNumbers;
    std::map<Key, Mesh> m_meshes;
    std::size_t m_totalVertices = 0;
    std::size_t m_doneVertices = 0;
};

/// assimp's message as one plain sentence part: "GLTF: …" and source locations say nothing to a user.
std::string cleaned(std::string message)
{
    for (char &c : message)
        c = c >= ' ' && c <= '~' ? c : ' ';
    constexpr std::string_view kPrefix = "GLTF: ";
    if (message.starts_with(kPrefix))
        message.erase(0, kPrefix.size());
    const std::size_t first = message.find_first_not_of(' ');
    message.erase(0, first == message.npos ? message.size() : first);
    while (!message.empty() && (message.back() == '.' || message.back() == ' ' || message.back() == '!'))
        message.pop_back();
    return message.empty() ? "the file cannot be understood" : message;
}

} // namespace

Model readWithAssimp(const Source &source)
{
    const std::vector<std::uint8_t> checked = checkedGltf(source);
    Source checkedSource = source;
    checkedSource.bytes = checked;
    // A GLB that is called .gltf.
    if (checked.size() >= 4 && checked[0] == 'g')
        checkedSource.suffix = "glb";

    Assimp::Importer importer;
    // The importer deletes both.
    importer.SetIOHandler(new AssimpFiles(checkedSource));
    importer.SetProgressHandler(new AssimpProgress(source.progress));
    const aiScene *scene = importer.ReadFile("model." + checkedSource.suffix, aiProcess_Triangulate);
    // assimp swallows the exceptions thrown through it.
    if (source.progress.isCancelled())
        throw Failure(ImportErrorCode::Cancelled);
    if (!scene) {
        if (const std::exception_ptr &exception = importer.GetException()) {
            try {
                std::rethrow_exception(exception);
            } catch (const std::bad_alloc &) {
                throw;
            } catch (const Failure &) {
                throw;
            } catch (const std::exception &) {
                // Its message follows.
            }
        }
        failMalformed(cleaned(importer.GetErrorString()));
    }
    return SceneConverter(*scene, source).convert();
}

} // namespace unprojector::mesh_import::mesh_reader
