// Decoded channels of scene files that several runs in a row read: those of a study, and those that follow edits.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageReader.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace Drydock
{

/** Holds the channels of one file, until the file changes or another is read. One thread at a time. */
class DRYDOCK_API FSceneCache
{
public:
	using FPlane = std::shared_ptr<const FImagePlane>;

	/** Forgets what it holds of another file, or of an older state of this one. */
	void Begin(const std::string& Path);

	/** Null where the channel with this index is not here. */
	FPlane Find(int Channel) const;

	void Keep(int Channel, FPlane Plane);

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
};

} // namespace Drydock
