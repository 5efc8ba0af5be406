// Makes the report of `drydock blend` for a config that is set up for a run.
#pragma once

#include "Blend/BlendReport.h"

namespace Drydock
{

struct FRunSetup;

/** The settings at the view's location, with the story of each. Console variables are those of the setup, which must
 * live on. LocationFrom: the source of the location. bExtensions: view extensions edit them, too, which calls the
 * code of plugins. Throws FError where an extension fails. */
FBlendReport MakeBlendReport(const FRunSetup& Setup, const std::string& LocationFrom, bool bExtensions = true);

} // namespace Drydock
