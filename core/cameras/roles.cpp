#include "core/cameras/roles.h"

#include "core/base/letters.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/cameras/scan.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <unordered_map>
#include <utility>

namespace unprojector::cameras {
using base::isDigit;
using base::isListed;
using enum EyeAxes;
using enum PoseDirection;
namespace {

/// What a word means in a name.
enum class Word {
    Unknown,
    Filler,
    Camera,    ///< a frame: the camera's
    World,     ///< a frame: the world's, or a body's that stands for it
    Side,      ///< which camera: "left", "depth"
    Transform, ///< T
    To,
    From,
    In,
    OpenGl,
    OpenCv,
    Intrinsics,
    Focal,
    Principal,
    Matrix,
    Rotation,
    Quaternion,
    Angles, ///< of a rotation, in an order or about an axis that nothing tells
    Translation,
    Center,
    Pose,
    Extrinsics,
    View,
    Projection,
    Distortion,
    Coefficients,
    Radial,
    Tangential,
    Size,
    Shape, ///< a size by rows
    Image,
    Model,
    Other ///< makes the numbers another thing's
};

constexpr std::string_view kFillers =
    " vector vec params param parameters parameter data value values new est gt opt optimal "
    "is of the my raw array np list point points length lengths pinhole final current xyzw "
    "wxyz double float const auto var let deg degree degrees rad radian radians ";
constexpr std::string_view kWorldFrames =
    " world w map m odom global g body b imu i base robot ego vehicle velodyne velo "
    "lidar rig object obj o marker board target ned enu ";

constexpr std::string_view kAngleWords = " euler eulers eul angleaxis angleaxisd rpy ypr roll pitch yaw azimuth "
                                         "elevation heading tilt rx ry rz axis angles ";

constexpr std::string_view kOtherThings =
    " std sigma cov covariance noise velocity speed error residual residuals jacobian inv "
    "inverse inverted delta relative limits min max bounds weights stereo fundamental "
    "essential homography mv mvp viewport ";

/// The words of each kind, in its order.
constexpr std::string_view kVocabulary[]{
    "",
    kFillers,
    " camera cam cams c cn cnm optical sensor s eye lens ", // Camera
    kWorldFrames,
    " left right color colour rgb depth ir infrared reference ref rect ", // Side
    " t transform transformation trafo tf se ",                           // Transform
    " to ",                                                               // To
    " from ",                                                             // From
    " in ",                                                               // In
    " gl opengl blender nerf ",                                           // OpenGl
    " cv opencv colmap ",                                                 // OpenCv
    " k intrinsic intrinsics intr intri intrin kmat ",                    // Intrinsics
    " focal fl ",                                                         // Focal
    " principal pp ",                                                     // Principal
    " matrix mat mtx ",                                                   // Matrix
    " r rot rotation rmat rvec rvecs rodrigues ",                         // Rotation
    " q quat quaternion orientation qvec quaterniond quaternionf dquat ", // Quaternion
    kAngleWords,                                                          // Angles
    " trans translation tvec tvecs ",                                     // Translation
    " center centre position pos origin location ",                       // Center
    " pose poses ",                                                       // Pose
    " extrinsic extrinsics extr extri ext rt ",                           // Extrinsics
    " view ",                                                             // View
    " p projection proj ",                                                // Projection
    " d dist distortion distort distorsion kc ",                          // Distortion
    " coeff coeffs coef coefs coefficients coefficient ",                 // Coefficients
    " radial ",                                                           // Radial
    " tangential ",                                                       // Tangential
    " size resolution imsize imgsz ",                                     // Size
    " shape hw ",                                                         // Shape
    " image img frame ",                                                  // Image
    " model type ",                                                       // Model
    kOtherThings,
};

Word kindOf(std::string_view word)
{
    static const std::unordered_map<std::string_view, Word> kinds = [] {
        std::unordered_map<std::string_view, Word> all;
        for (std::size_t kind = 0; kind < std::size(kVocabulary); ++kind) {
            base::TextScanner scanner(kVocabulary[kind]);
            for (std::string_view one = scanner.nextWord(); !one.empty(); one = scanner.nextWord())
                all.emplace(one, Word(kind));
        }
        return all;
    }();
    const auto found = kinds.find(word);
    return found == kinds.end() ? Word::Unknown : found->second;
}

bool isFrame(Word kind)
{
    return kind == Word::Camera || kind == Word::World;
}

/// Returns whether a word of a kind stands before or between the frames of a transform.
bool isTransformWord(Word kind)
{
    using enum Word;
    return kind == Transform || kind == Extrinsics || kind == Rotation || kind == Quaternion || kind == Translation
           || kind == Pose;
}

/// Letters in front of two frames: T_WC, R_cw, q_WC.
bool isTurnOrShift(std::string_view word)
{
    return word.size() == 1 && std::string_view("txhrqp").find(word[0]) != std::string_view::npos;
}

/// The word of a letter that is a frame beside another one: l, a lidar's, is left's elsewhere.
std::string frameOf(char letter)
{
    return letter == 'l' ? "lidar" : std::string(1, letter);
}

/// Returns whether two letters are a camera's and a world's frame.
bool areFrames(std::string_view two)
{
    const auto isCamera = [](char c) { return c == 'c' || c == 's'; };
    return two.size() == 2 && isFrame(kindOf(frameOf(two[0]))) && isFrame(kindOf(frameOf(two[1])))
           && isCamera(two[0]) != isCamera(two[1]);
}

/// Splits a word that is several known ones: "camtoworld", "rotmat". The longest known word comes
/// first, and every part has three letters or is "to".
bool splitIntoKnown(std::string_view word, std::vector<std::string> &parts)
{
    if (word.empty())
        return true;
    constexpr std::size_t kLongest = 15, kMost = 6; // letters of a word, and words
    if (parts.size() == kMost)
        return false;
    for (std::size_t length = std::min(word.size(), kLongest); length >= 2; --length) {
        const std::string_view first = word.substr(0, length);
        const Word kind = kindOf(first);
        constexpr std::string_view kShort = " to rt gl cv ";
        if (kind == Word::Unknown || (length == 2 && !isListed(kShort, first)))
            continue;
        parts.emplace_back(first);
        if (splitIntoKnown(word.substr(length), parts))
            return true;
        parts.pop_back();
    }
    return false;
}

/// Adds a word between marks and changes of case, split further where its parts are known.
void addWord(const std::string &word, std::vector<std::string> &words)
{
    const std::string_view letters = word;
    std::vector<std::string> parts;
    const Word before = words.empty() ? Word::Unknown : kindOf(words.back());
    const bool isBehindFrame = isFrame(before),
               isBehindTurn = isTransformWord(before) || (!words.empty() && isTurnOrShift(words.back()));
    const bool areTwo = (isBehindTurn && areFrames(letters)) // T_WC, wTc
                        || (isBehindFrame && isTurnOrShift(letters.substr(0, 1)) && isFrame(kindOf(letters.substr(1))));
    const bool areThree = letters.size() == 3 && isTurnOrShift(letters.substr(0, 1)) && areFrames(letters.substr(1))
                          && letters.find('c', 1) != letters.npos; // Twc
    const bool isKnown = kindOf(word) != Word::Unknown;
    if (!isKnown && areTwo)
        parts = {word.size() == 2 ? frameOf(word[0]) : word.substr(0, 1),
                 word.size() == 2 ? frameOf(word[1]) : word.substr(1)};
    else if (!isKnown && areThree)
        parts = {word.substr(0, 1), frameOf(word[1]), frameOf(word[2])};
    else if (isKnown || !splitIntoKnown(letters, parts))
        parts = {word};
    words.insert(words.end(), parts.begin(), parts.end());
}

/// The words of a name, split between known words too.
std::vector<std::string> knownWordsOf(std::string_view name)
{
    std::vector<std::string> words;
    for (const std::string &word : wordsOf(name))
        addWord(word, words);
    return words;
}

constexpr std::size_t kLongestName = 80; // longer ones are prose

/// The words of a name with what they mean, without its numbers.
struct Name {
    explicit Name(std::string_view name) : words(knownWordsOf(name.substr(0, kLongestName)))
    {
        std::erase_if(words, [](const std::string &word) { return isDigit(word[0]); });
        for (const std::string &word : words)
            kinds.push_back(kindOf(word));
        for (std::size_t i = 0; i + 1 < words.size(); ++i) { // X_WC
            if ((words[i] == "x" || words[i] == "h") && isFrame(kinds[i + 1]))
                kinds[i] = Word::Transform;
        }
    }

    /// Returns whether the name has a word of any of these kinds.
    bool has(std::same_as<Word> auto... some) const
    {
        return std::ranges::any_of(kinds, [&](Word kind) { return ((kind == some) || ...); });
    }
    /// Returns whether the name has a word of a list.
    bool hasWord(std::string_view list) const
    {
        return std::ranges::any_of(words, [&](const std::string &word) { return isListed(list, word); });
    }
    /// Returns whether the name has none but these kinds and those that say nothing.
    bool isOnly(std::same_as<Word> auto... some) const
    {
        return std::ranges::all_of(kinds, [&](Word kind) {
            return kind == Word::Filler || kind == Word::Camera || kind == Word::Side || ((kind == some) || ...);
        });
    }

    std::vector<std::string> words;
    std::vector<Word> kinds;
};

/// The frames that a transform leads from and to: indexes of words.
struct Frames {
    std::optional<std::size_t> from, to;
};

Frames framesOf(const Name &name)
{
    using enum Word;
    const std::vector<Word> &kinds = name.kinds;
    const auto at = [&](std::size_t i) { return i < kinds.size() ? kinds[i] : Unknown; };
    const auto isEnd = [&](std::size_t i) { return isFrame(at(i)) || at(i) == Side; };
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::optional<std::size_t> before = i > 0 && isEnd(i - 1) ? std::optional(i - 1) : std::nullopt;
        std::size_t next = i + 1;
        while (isEnd(next) && isEnd(next + 1) && at(next) != World) // "to_left_camera"
            ++next;
        if (!isEnd(next))
            continue;
        if (at(i) == To || at(i) == In)
            return {before, next};
        if (at(i) == From)
            return {next, before};
    }
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const bool isTransform = isTransformWord(at(i)) || isTurnOrShift(name.words[i]);
        const bool isBehindFrame = i > 0 && isFrame(at(i - 1));
        if (isTransform && isEnd(i + 1) && isEnd(i + 2) && (at(i + 1) != at(i + 2) || !isBehindFrame))
            return {i + 2, i + 1}; // T_world_cam
        if (isTransform && isBehindFrame && isFrame(at(i + 1)) && at(i - 1) != at(i + 1))
            return {i + 1, i - 1}; // world_T_cam
    }
    return {};
}

/// Sets the direction that a name states by its frames.
/// @return false for a transform between two cameras or two worlds
bool setFrames(const Name &name, Role &role)
{
    const Frames frames = framesOf(name);
    if (!frames.from && !frames.to)
        return true;
    const auto isWorld = [&](std::size_t i) { return name.kinds[i] == Word::World; };
    if (frames.from && frames.to && isWorld(*frames.from) == isWorld(*frames.to))
        return false;
    const bool isFromWorld = frames.from ? isWorld(*frames.from) : !isWorld(*frames.to);
    role.direction = isFromWorld ? WorldToCamera : CameraToWorld;
    role.isDirectionStated = true;
    const std::optional<std::size_t> world = isFromWorld ? frames.from : frames.to;
    constexpr std::string_view kWorlds = " world w global g map m odom ";
    if (world && !isListed(kWorlds, name.words[*world]))
        role.world = name.words[*world];
    return true;
}

/// A name that means another direction than its words.
struct NameOfProgram {
    std::string_view name;
    std::optional<PoseDirection> direction; ///< none: programs write either
    std::string_view world;
};
constexpr std::array kNamesOfPrograms{
    NameOfProgram{"extrinsicRotation", CameraToWorld, "imu"}, // VINS-Mono
    NameOfProgram{"extrinsicTranslation", CameraToWorld, "imu"},
    NameOfProgram{"T_cn_cnm1", WorldToCamera, "camera before"},  // Kalibr
    NameOfProgram{"CameraExtrinsicMat", std::nullopt, "lidar"}}; // Autoware, and others the other way

/// The part by the words that are not frames.
std::optional<Part> partOf(const Name &name, std::size_t count)
{
    using enum Word;
    const auto partIf = [](bool isIt, Part part) { return isIt ? std::optional(part) : std::nullopt; };
    const bool isMatrix = name.has(Matrix), isTransform = name.has(Transform), isRotation = name.has(Rotation);
    const bool hasFrames = framesOf(name).from || framesOf(name).to;
    const std::string alone = name.words.size() == 1 ? name.words[0] : std::string();
    if (name.has(Model) && !name.has(View))
        return partIf(name.isOnly(Model, Distortion), Part::Model);
    if (name.has(Size, Shape)) // a sensor's is in millimetres
        return partIf(name.isOnly(Size, Shape, Image) && !(name.hasWord("sensor") && name.has(Size)), Part::Size);
    for (const auto &[kind, part] : {std::pair(Radial, Part::Radial), std::pair(Tangential, Part::Tangential)}) {
        if (name.has(kind) && name.isOnly(kind, Distortion, Coefficients))
            return part;
    }
    if (name.has(Distortion, Coefficients) && name.isOnly(Distortion, Coefficients, Image))
        return Part::Distortion;
    if (name.has(Focal) || (alone == "f" && count == 2)) // "f: [600, 610]"
        return Part::Focal;
    if (name.has(Principal) || (isListed(" c p ", alone) && count == 2)) // RealSense's "p[320 240]"
        return Part::Principal;
    if (isRotation && (name.hasWord("rect") || (isMatrix && count < 9))) // KITTI's R_rect
        return std::nullopt;
    if (isRotation || name.has(Quaternion))
        return count == 4 || name.has(Quaternion) ? Part::Quaternion : Part::Rotation;
    if (name.has(Translation))
        return Part::Translation;
    if (name.has(Center))
        return count == 12 || count == 16 ? Part::Pose : Part::Center;
    if (count == 3 && !name.words.empty() && isListed(" c eye ", name.words.back()) && name.isOnly())
        return Part::Center;
    if ((name.has(Intrinsics) && !hasFrames) || (count == 9 && alone == "m")) // OpenCV's stereo_calib
        return Part::Intrinsics;
    if (name.hasWord("p") && hasFrames && count == 3) // Drake's p_WC
        return Part::Translation;
    if (name.has(Projection) && name.isOnly(Projection, Matrix))
        return Part::CameraMatrix;
    if (name.has(Pose, Extrinsics, View) || isTransform || hasFrames || (isMatrix && name.has(World)))
        return isTransform && count <= 6 ? Part::Translation : Part::Pose; // t, or its vectors
    return partIf(isMatrix && name.isOnly(Matrix) && (name.has(Camera) || name.hasWord("mtx")), Part::Intrinsics);
}

/// Returns whether unknown words may stand beside a part's: its count of numbers is rare.
bool allowsUnknown(Part part, std::size_t count)
{
    return (part == Part::Intrinsics && count == 9) || (part == Part::Pose && (count == 12 || count == 16));
}

/// Sets what a pose's words usually mean.
void setCustom(const Name &name, Role &role)
{
    using enum Word;
    if (name.has(OpenGl, View))
        role.axes = RightUpBack;
    else if (name.has(OpenCv) || name.hasWord("rt"))
        role.axes = RightDownAhead;
    role.areAxesStated = name.has(OpenGl, OpenCv) || name.hasWord("rt");
    if (role.direction)
        return;
    const bool isOfObject = name.has(Matrix) && name.has(World); // Blender's matrix_world
    const bool isCameras = name.has(Camera) && name.has(Transform);
    const bool isOpen = name.hasWord("ext");                             // of a camera to an IMU, or the other way
    if ((name.has(Extrinsics, View) && !isOpen) || name.hasWord("qvec")) // COLMAP's qvec
        role.direction = WorldToCamera;
    else if (name.has(Pose) || isOfObject || isCameras || name.hasWord("position pos location")) // an object's
        role.direction = CameraToWorld;
}

bool isOfOther(const Name &name)
{
    using enum Word;
    constexpr std::string_view kOthers =
        " imu lidar marker markers object objects obj robot projector display window screen monitor crop roi thumbnail "
        "checkerboard bbox box tag light board velodyne ";
    return !name.has(Pose, Extrinsics, Transform) && name.hasWord(kOthers);
}

bool areAngles(const Name &name)
{
    using enum Word;
    return name.has(Angles, Rotation, Quaternion) && !name.has(Other) && !isOfOther(name);
}

} // namespace

std::optional<Role> roleOf(std::string_view text, std::size_t count)
{
    using enum Word;
    const Name name(text);
    const bool isOfPipeline = name.has(View) && name.has(Model, Projection);
    if (name.words.empty() || name.has(Other, Angles) || isOfPipeline || text.size() > kLongestName)
        return std::nullopt;
    const std::optional<Part> part = partOf(name, count);
    const bool isF = part == Part::Focal && name.words.size() == 1;
    if (!part || (name.has(Unknown) && !allowsUnknown(*part, count) && !isF))
        return std::nullopt;
    if (count == 1 && *part != Part::Distortion && *part != Part::Model)
        return std::nullopt;
    Role role{*part};
    role.areRowsFirst = name.has(Shape) || text.find("ImageSize") != text.npos;
    if (!isOfPose(*part))
        return role;
    for (const NameOfProgram &known : kNamesOfPrograms) {
        if (text == known.name) {
            role.direction = known.direction;
            role.isDirectionStated = known.direction.has_value();
            role.world = known.world;
            return role;
        }
    }
    if (!setFrames(name, role))
        return std::nullopt;
    // "marker_pose", "R_imu": of another thing than a camera
    constexpr std::string_view kWorlds = " world w global g map odom c cam camera ";
    const bool isOfOtherWorld = std::ranges::any_of(
        name.words, [&](const std::string &word) { return kindOf(word) == World && !isListed(kWorlds, word); });
    if (!role.isDirectionStated && isOfOtherWorld && !name.has(Camera))
        return std::nullopt;
    setCustom(name, role);
    if (name.has(Unknown) && !role.isDirectionStated)
        role.direction.reset(); // "head_pose"
    const bool isTfEcho = text == "in Quaternion";
    role.w = name.hasWord("xyzw") || isTfEcho ? 3 : name.hasWord("wxyz") || name.hasWord("qvec") ? 0 : 4;
    return role;
}

bool isElsewhere(std::string_view text)
{
    return isOfOther(Name(text));
}

bool isBetweenCameras(std::string_view text)
{
    Role role;
    return !setFrames(Name(text), role);
}

std::string cameraOf(std::string_view text)
{
    // "T_cam1_world", "K_cam0", "K_02"
    for (std::size_t at = base::lowerCase(text).find("cam"); at != text.npos;
         at = base::lowerCase(text).find("cam", at + 1)) {
        const std::size_t begin = text.find_first_of("0123456789", at),
                          end = std::min(text.find_first_not_of("0123456789", begin), text.size());
        const std::string_view between = text.substr(at, std::min(begin, text.size()) - at);
        const bool isNumbered = between.size() == 3 || base::lowerCase(between) == "camera";
        if (begin != text.npos && isNumbered && (end == text.size() || !base::isLetter(text[end]) || text[end] == '_'))
            return std::string(text.substr(begin, end - begin)); // but not "cam2world"
    }
    const std::size_t digits = text.find_last_not_of("0123456789") + 1;
    if (digits > 0 && digits < text.size() && text.size() - digits <= 3)
        return std::string(text.substr(digits));
    for (const std::string &word : Name(text).words) {
        if (kindOf(word) == Word::Side && word != "rect")
            return word;
    }
    return {};
}

bool hasPartWord(std::string_view text)
{
    using enum Word;
    const Name name(text);
    return std::ranges::any_of(name.kinds, [](Word kind) {
        return (kind >= Intrinsics && kind <= View && kind != Matrix) || kind == Transform || kind == Distortion;
    });
}

bool isAngle(std::string_view text)
{
    return areAngles(Name(text));
}

bool isScalarOfPart(std::string_view text)
{
    using enum Word;
    constexpr std::string_view kOthers = " skew gamma s alphac tx ty tz qx qy qz qw ";
    const Name name(text);
    const bool isOfLens = name.has(Distortion, Radial, Tangential, Focal, Principal);
    return isOfLens || !coefficientOf(text).empty() || isListed(kOthers, plain(text))
           || (areAngles(name) && !name.has(Unknown));
}

std::string coefficientOf(std::string_view text)
{
    std::string name = plain(text);
    for (const std::string_view word :
         {"radial", "tangential", "distortion", "disto", "dist", "lens", "camera", "cam", "coeff", "coef", "param"}) {
        if (const std::size_t at = name.find(word); at != name.npos)
            name.erase(at, word.size());
    }
    const bool isNumbered = name.size() == 2 && isListed(" k p s d ", name.substr(0, 1)) && isDigit(name[1]);
    return isNumbered || name.starts_with("kappa") || isListed(" xi tau taux tauy ", name) ? name : std::string();
}

} // namespace unprojector::cameras
