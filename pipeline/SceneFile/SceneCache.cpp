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
		Textures.clear();
		Contents.clear();
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

const FKeptSceneTexture* FSceneCache::FindTexture(const std::string& Name) const
{
	const auto Found = Textures.find(Name);
	return Found == Textures.end() ? nullptr : &Found->second;
}

void FSceneCache::KeepTexture(const std::string& Name, FKeptSceneTexture Texture)
{
	Textures[Name] = std::move(Texture);
}

std::optional<FViewContent> FSceneCache::FindContent(const std::string& Key) const
{
	const auto Found = Contents.find(Key);
	return Found == Contents.end() ? std::nullopt : std::optional(Found->second);
}

void FSceneCache::KeepContent(const std::string& Key, const FViewContent& Content)
{
	constexpr size_t Most = 64;
	if (Contents.size() >= Most)
	{
		Contents.clear();
	}
	Contents[Key] = Content;
}

} // namespace Drydock
