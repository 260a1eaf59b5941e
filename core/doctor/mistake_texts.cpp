#include "core/doctor/mistake_texts.h"

#include "core/base/translation.h"
#include "core/doctor/remedies.h"

#include <cstddef>

namespace unprojector::doctor {
using base::tr;
namespace {

std::string nameOf(const KnownPoint &known)
{
    switch (known.kind) {
    case KnownPoint::Kind::Eye: return tr("the eye");
    case KnownPoint::Kind::ViewTranslation: return tr("the translation of the view matrix");
    case KnownPoint::Kind::CameraCentre: return tr("the camera's centre");
    case KnownPoint::Kind::WorldOrigin: return tr("the world's origin");
    case KnownPoint::Kind::ObjectOrigin: return tr("the origin of \"%1\"", known.object);
    case KnownPoint::Kind::Vertex: break;
    }
    return tr("vertex %1 of \"%2\"", known.vertex, known.object);
}

/// The usual cause, as a clause.
std::string reasonOf(const KnownPoint &known)
{
    switch (known.kind) {
    case KnownPoint::Kind::Eye:
        return tr("the program returns where the ray begins: the translation of the view's inverse, or the point at a "
                  "distance of 0");
    case KnownPoint::Kind::ViewTranslation:
        return tr("the program reads the eye from the last column of the view matrix; it is in the last column of the "
                  "inverse");
    case KnownPoint::Kind::CameraCentre:
        return tr("the program returns the point that the camera looks at, for every click");
    case KnownPoint::Kind::WorldOrigin:
        return tr("the result was never set: a call failed or the ray hit nothing, and the program did not check it");
    case KnownPoint::Kind::ObjectOrigin:
        return tr(
            "the program returns the translation of the model matrix: the object's position, not the clicked point");
    case KnownPoint::Kind::Vertex: break;
    }
    return tr("the program returns the nearest vertex of the mesh, not the point that is clicked");
}

std::string sharedSentence(Shared shared)
{
    switch (shared) {
    case Shared::Window: return tr("Both unproject the same wrong window position.");
    case Shared::Depth: return tr("Both unproject the same wrong depth.");
    case Shared::Projection: return tr("Both use the same wrong projection matrix.");
    case Shared::View: return tr("Both use the same wrong view matrix.");
    case Shared::Ndc: return tr("Both reach the same wrong NDC position.");
    case Shared::Matrix: return tr("Both multiply by the same wrong matrix.");
    case Shared::Point: break;
    }
    return tr("They reach the same wrong point in different ways.");
}

} // namespace

std::vector<std::string> partsOf(std::string_view id)
{
    if (id.empty() || id == "right" || id == "unknown" || id == "known-point")
        return {};
    const std::size_t plus = id.find('+');
    if (plus == id.npos)
        return {std::string(id)};
    return {std::string(id.substr(0, plus)), std::string(id.substr(plus + 1))};
}

std::string mistakeName(std::string_view id)
{
    std::string names;
    for (const std::string &part : partsOf(id))
        names += (names.empty() ? "" : " + ") + tr(remedyOf(part).name);
    return names;
}

std::string mistakeSentence(std::string_view id)
{
    std::string sentences;
    for (const std::string &part : partsOf(id)) {
        const std::string next = tr(remedyOf(part).sentence);
        sentences = sentences.empty() ? next : tr("%1 %2|sentences", sentences, next);
    }
    return sentences;
}

std::string candidateSentence(const Candidate &candidate)
{
    std::string sentences;
    for (const VariantName &way : candidate.ways) {
        if (way.sentence != nullptr) {
            const std::string next = tr(way.sentence, way.value, way.second, way.third, way.fourth);
            sentences = sentences.empty() ? next : tr("%1 %2|sentences", sentences, next);
        }
    }
    const std::string sentence = mistakeSentence(candidate.id);
    return sentences.empty() ? sentence : tr("%1 %2|sentences", sentences, sentence);
}

std::string waysText(const std::vector<VariantName> &ways)
{
    std::string text;
    for (const VariantName &way : ways) {
        const std::string next =
            way.words == nullptr ? way.value : tr(way.words, way.value, way.second, way.third, way.fourth);
        text = text.empty() ? next : tr("%1; %2|ways", text, next);
    }
    return text;
}

std::string knownPointName(const std::vector<KnownPoint> &known)
{
    std::string names;
    for (const KnownPoint &one : known)
        names = names.empty() ? nameOf(one) : tr("%1 and %2|names", names, nameOf(one));
    return names;
}

std::string knownPointSentence(const std::vector<KnownPoint> &known)
{
    std::string sentences = tr("The point given is %1.", knownPointName(known));
    for (std::size_t i = 0; i < known.size(); ++i)
        sentences = tr("%1 %2|sentences", sentences, tr(i == 0 ? "Usually %1." : "Or %1.", reasonOf(known[i])));
    return sentences;
}

std::string alikeSentence(const Candidate &candidate)
{
    const std::string shared = candidate.shared ? sharedSentence(*candidate.shared) : std::string();
    switch (candidate.alike) {
    case Alike::No: break;
    case Alike::InDigits:
        return candidate.hasNumbers()
                   ? tr("Both have a value that explains these points: another click separates them.")
                   : tr("These digits cannot separate them: give more digits, or another click.");
    case Alike::Here:
        return tr("%1 %2|sentences", shared, tr("They give the same point here: another click separates them."));
    case Alike::Always:
        return tr("%1 %2|sentences", shared,
                  tr("They cannot be separated: every click in this scene gives the same point."));
    }
    return {};
}

} // namespace unprojector::doctor
