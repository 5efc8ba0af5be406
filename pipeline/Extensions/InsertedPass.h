// A pass of the config's `passes` as a view extension: it adds the pass at its hook, like any other subscriber.
#pragma once

#include "Extensions/ConfigExtensions.h"
#include "SceneViewExtension.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace Drydock
{

/** Results of the inserted passes of one run, by view and name: what later passes read. */
using FPassResults = std::map<std::pair<const FSceneView*, std::string>, FScreenPassTexture>;

/** One that subscribes or, at PrePostProcessPass, edits scene colour in place. Called in the order of the requests
 * where it is made in that order. Results: shared by all of a run. */
TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> CreateInsertedPass(
	const FPassRequest& Request, const std::shared_ptr<FPassResults>& Results);

} // namespace Drydock
