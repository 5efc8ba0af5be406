// Objects that stand for a project's assets: the run's config gives them, and code asks for them by path or by name.
#pragma once

#include "CoreTypes.h"

#include <functional>
#include <string>

class UObject;

namespace Drydock
{

/** The object of a text, or null; Problem: why an object that exists cannot be had, empty otherwise. */
struct FGivenAsset
{
	UObject* Asset = nullptr;
	std::string Problem;
};

using FAssetFinder = std::function<FGivenAsset(const std::string& Text)>;

/** Replaces what finds assets from now on; empty: there are none. */
DRYDOCK_API void SetAssetFinder(FAssetFinder Finder);

/** Text: the path of an asset in any of the engine's forms, its name, or what else the finder knows. */
DRYDOCK_API FGivenAsset FindGivenAsset(const std::string& Text);

} // namespace Drydock
