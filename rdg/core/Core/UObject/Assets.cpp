// Asks the finder of assets that the run has set.
#include "UObject/Assets.h"

#include "UObject/Object.h"

namespace
{

Drydock::FAssetFinder& GetFinder()
{
	static Drydock::FAssetFinder Finder;
	return Finder;
}

} // namespace

void Drydock::SetAssetFinder(FAssetFinder Finder)
{
	GetFinder() = std::move(Finder);
}

Drydock::FGivenAsset Drydock::FindGivenAsset(const std::string& Text)
{
	return GetFinder() ? GetFinder()(Text) : FGivenAsset();
}

UObject* Drydock::FindAsset(const TCHAR* Path)
{
	return Path != nullptr ? FindGivenAsset(Path).Asset : nullptr;
}
