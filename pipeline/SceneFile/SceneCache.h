// Keeps of a scene file what several runs in a row need, such as those of a study and those that follow edits: decoded
// channels, scene textures made of them, and what was measured on them.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageReader.h"
#include "RHITexture.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/ViewContent.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A scene texture with all its texels. */
struct FKeptSceneTexture
{
	std::string Key; // of all that decides the texels
	TRefCountPtr<FRHITexture> Texture;
	std::vector<FNonFiniteChannel> NonFinite; // found on the way
};

/** Holds what belongs to one file, until the file changes or another is read. One thread at a time. */
class DRYDOCK_API FSceneCache
{
public:
	using FPlane = std::shared_ptr<const FImagePlane>;

	/** Forgets what it holds of another file, or of an older state of this one. */
	void Begin(const std::string& Path);

	/** Null where the channel with this index is not here. */
	FPlane Find(int Channel) const;

	void Keep(int Channel, FPlane Plane);

	/** The texture of that name, by whatever key; null where there is none. */
	const FKeptSceneTexture* FindTexture(const std::string& Name) const;

	/** In place of the one that it has of this name. Nobody writes to it as long as it is here: see ForgetTexture. */
	void KeepTexture(const std::string& Name, FKeptSceneTexture Texture);
	void ForgetTexture(const std::string& Name) { Textures.erase(Name); }

	/** Key: of all that decides the answers, for the channels that are here. */
	std::optional<FViewContent> FindContent(const std::string& Key) const;
	void KeepContent(const std::string& Key, const FViewContent& Content);

private:
	struct FState
	{
		std::string Path;
		std::filesystem::file_time_type Time;
		std::uintmax_t Size = 0;

		bool operator==(const FState&) const = default;
	};

	FState State;
	std::map<int, FPlane> Planes;
	std::map<std::string, FKeptSceneTexture> Textures; // by name
	std::map<std::string, FViewContent> Contents;
};

} // namespace Drydock
