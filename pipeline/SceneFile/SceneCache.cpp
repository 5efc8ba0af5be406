// Tells a file from what it was by its time and size.
#include "SceneFile/SceneCache.h"

namespace Drydock
{

void FSceneCache::Begin(const std::string& Path)
{
	std::error_code Ignored;
	const FState Now = {
		Path, std::filesystem::last_write_time(Path, Ignored), std::filesystem::file_size(Path, Ignored)};
	if (!(Now == State))
	{
		State = Now;
		Planes.clear();
	}
}

FSceneCache::FPlane FSceneCache::Find(int Channel) const
{
	const auto Found = Planes.find(Channel);
	return Found == Planes.end() ? nullptr : Found->second;
}

void FSceneCache::Keep(int Channel, FPlane Plane)
{
	Planes[Channel] = std::move(Plane);
}

} // namespace Drydock
