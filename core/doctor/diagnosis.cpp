#include "core/doctor/diagnosis.h"

namespace unprojector::doctor {

Result<Diagnosis> diagnose(const Case &scene, std::span<const WrongPoint>)
{
    if (const Check valid = check(scene.picture); !valid)
        return valid.error();
    Diagnosis diagnosis;
    diagnosis.verdict = "unknown";
    return diagnosis;
}

std::vector<std::string> mistakeIds()
{
    return {};
}

} // namespace unprojector::doctor
