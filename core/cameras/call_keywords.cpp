#include "core/cameras/call_keywords.h"

#include "core/base/translation.h"
#include "core/cameras/call_syntax.h"
#include "core/cameras/pasted_matrix.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace unprojector::cameras {
using base::tr;
using namespace syntax;

namespace {

/// The keywords of an argument in any API: in lower case, without underscores, between blanks.
using Keywords = std::string_view;

constexpr Keywords kAngle = " fov fovy fieldofview verticalfov yfov ";
constexpr Keywords kAspect = " aspect aspectratio ";
constexpr Keywords kNear = " near nearval znear nearplane znearplane nearplanedistance nearz depthnear neardist n ";
constexpr Keywords kFar = " far farval zfar farplane zfarplane farplanedistance farz depthfar fardist f ";
constexpr Keywords kWidth = " width viewwidth w ", kHeight = " height viewheight h ";
constexpr Keywords kLeft = " left viewleft l ", kRight = " right viewright r ";
constexpr Keywords kBottom = " bottom viewbottom b ", kTop = " top viewtop t ";
constexpr Keywords kEye = " eye eyeposition position cameraposition cameraeyeposition ";
constexpr Keywords kCenter = " center centre at target focusposition cameratarget cameratargetposition ";
constexpr Keywords kDirection = " direction dir eyedirection cameradirection ";
constexpr Keywords kUp = " up upvector updirection cameraup cameraupvector ";

std::vector<Keywords> keywordsOf(CallShape shape)
{
    switch (shape) {
    case CallShape::FieldOfView: return {kAngle, kAspect, kNear, kFar};
    case CallShape::FieldOfViewOfSize: return {kAngle, kWidth, kHeight, kNear, kFar};
    case CallShape::Size: return {kWidth, kHeight, kNear, kFar};
    case CallShape::Edges: return {kLeft, kRight, kBottom, kTop, kNear, kFar};
    case CallShape::EdgesTopFirst: return {kLeft, kRight, kTop, kBottom, kNear, kFar};
    case CallShape::EdgesOnly: return {kLeft, kRight, kBottom, kTop};
    case CallShape::LookAtNumbers:
        return {" eyex ", " eyey ", " eyez ", " centerx ", " centery ", " centerz ", " upx ", " upy ", " upz "};
    case CallShape::LookAtPoints: return {kEye, kCenter, kUp};
    case CallShape::LookTo: return {kEye, kDirection, kUp};
    case CallShape::Viewport: break;
    }
    return {" x ", " y ", kWidth, kHeight};
}

struct Argument {
    std::string keyword, value; ///< the keyword is empty for an argument by position
};

Argument argumentOf(const std::string &text)
{
    std::size_t end = 0;
    while (end < text.size() && (isLetter(text[end]) || isDigit(text[end])))
        ++end;
    const std::size_t sign = behindBlanks(text, end);
    const bool isKeyword = end > 0 && isLetter(text[0]) && sign + 1 < text.size()
                           && (text[sign] == '=' || text[sign] == ':') && text[sign + 1] != text[sign];
    if (!isKeyword)
        return {{}, text};
    return {text.substr(0, end), std::string(trimmed(std::string_view(text).substr(sign + 1)))};
}

} // namespace

void failCall(std::string text)
{
    PasteError error{std::move(text)};
    error.isOfCall = true;
    throw error;
}

void sortByKeyword(CallText &call, CallShape shape)
{
    std::vector<std::string> &arguments = call.arguments;
    const std::vector<Keywords> keywords = keywordsOf(shape);
    std::vector<std::string> sorted;
    std::vector<bool> isGiven(std::max(arguments.size(), keywords.size()), false);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        Argument argument = argumentOf(arguments[i]);
        const std::string name = ' ' + plain(argument.keyword) + ' '; // as in a list of keywords
        if (name == " physicsclientid ")
            continue;
        std::size_t at = i;
        if (!argument.keyword.empty()) {
            const auto found = std::find_if(keywords.begin(), keywords.end(),
                                            [&name](Keywords some) { return some.find(name) != some.npos; });
            if (found == keywords.end())
                failCall(tr("%1: the argument '%2' is not known. Use the names of the call's own arguments, or none",
                            call.written, argument.keyword));
            at = std::size_t(found - keywords.begin());
        }
        if (isGiven[at])
            failCall(tr("%1: the argument '%2' is given twice. Remove one of them", call.written,
                        argument.keyword.empty() ? argument.value : argument.keyword));
        isGiven[at] = true;
        sorted.resize(std::max(sorted.size(), at + 1));
        sorted[at] = std::move(argument.value);
    }
    arguments = std::move(sorted);
}

} // namespace unprojector::cameras
