// Reads the rendered frame that a run starts from. Its channels are registered as external textures without memory;
// after culling, one read brings what surviving passes use. See configs/scenes/README.md.
#pragma once

#include "Config/Config.h"
#include "Picture/ImageFile.h"
#include "RHIResources.h"
#include "RenderGraphFwd.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneCache.h"
#include "SceneFile/SceneCamera.h"
#include "SceneFile/SceneChannel.h"
#include "SceneFile/SceneResolution.h"
#include "SceneFile/SceneTexturePacking.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FChannelValues;

/** A scene texture that the compiled graph uses, and the first surviving pass that does. */
struct FNeededSceneTexture
{
	std::string Texture;
	std::string Pass;
	bool bIsRead = true; // false: the pass may leave it unread, so a missing channel is not an error
};

class DRYDOCK_API FSceneFile
{
public:
	/** Reads the header only. Throws FError: no scene in the config (exit code 2), a file that cannot be read (3),
	 * channel names that do not exist (2). Cache: where channels are looked for and kept; null: nowhere. */
	explicit FSceneFile(const FConfig& Config, FSceneCache* InCache = nullptr);

	/** Registers and loads at another resolution than the file's. Regions: of each view, in the picture; what lies
	 * outside of them is padding. Before RegisterTextures; none, and 100: as the file is. */
	void SetResolution(double InScreenPercentage, std::vector<FSceneRegion> InRegions);

	/** Before RegisterTextures, with the context that Load will have: textures that the cache holds filled in the same
	 * way are registered as they are. */
	void UseKeptTextures(const FScenePackContext& Context);

	/** A pass of the graph writes to this texture, so that no other frame may use it. */
	void ForgetKept(const std::string& Texture);

	/** Null: nothing is kept. */
	FSceneCache* GetCache() const { return Cache; }

	/** Extent of the scene textures: the picture and its padding. */
	FIntPoint GetExtent() const;

	/** The same at the file's resolution: that of the output. */
	FIntPoint GetOutputExtent() const;

	/** The picture's pixels in the output. */
	FIntRect GetPictureRect() const;

	/** The camera of the header's drydock:camera_json; empty when there is none. */
	const std::optional<FSceneCamera>& GetCamera() const { return Camera; }

	/** Seconds from one frame to the next, from the same; empty when it does not say. */
	const std::optional<double>& GetDeltaTime() const { return DeltaTime; }

	/** Colour of the main light, relative, from the same header; white when there is none (SceneLight.h). */
	const FLinearColor& GetLightColor() const { return LightColor; }

	/** Registers every texture that the packing table knows, optional ones where the file has something of them; none
	 * has memory until Load. The others stay null. */
	FSceneTextures RegisterTextures(FRDGBuilder& GraphBuilder);

	/** The registered texture of that name, as the RHI has it; null when there is none. */
	FRHITexture* GetTexture(const std::string& Name) const;

	/** Fills the textures named that are not filled yet, from one read of the file; others are not its business. Throws
	 * FError (exit code 3) when the file is broken or lacks a channel of a texture that is read. */
	void Load(const std::vector<FNeededSceneTexture>& Needed, const FScenePackContext& Context);

	/** Marks the channels that Load would decode, and reads nothing. Throws as Load does for missing channels. */
	void Plan(const std::vector<FNeededSceneTexture>& Needed);

	/** Values of the channels named, by the names that passes know; one that the file lacks and that has no default is
	 * left out. The named channels count as decoded, and are kept for Load with scene colour, which comes in the same
	 * read. The values live until then. */
	std::map<std::string, FChannelValues> ReadChannels(const std::vector<std::string>& Names);

	/** Source and destination of a view's pixels; ViewRect in the scene textures. */
	FSceneRegion FindRegion(const FIntRect& ViewRect) const;

	/** Loaded, or planned to be. */
	bool IsFilled(const std::string& Texture) const;

	/** The channels that were loaded with what is not finite, before r.Drydock.NonFinite did anything about it. */
	const std::vector<FNonFiniteChannel>& GetNonFinite() const { return NonFinite; }

	/** All channels of the file. */
	const std::vector<FSceneChannel>& GetChannels() const { return Channels; }

private:
	/** Source of one of drydock's channels: a plane of the file, or a constant. */
	struct FSource
	{
		int FileChannel = -1;
		float Default = 0.0f;
	};
	struct FFill
	{
		const FScenePacking* Packing = nullptr;
		FRHITexture* Texture = nullptr;
		std::vector<FSource> Sources; // one to a channel slot in use
	};
	using FPlanes = std::map<int, FSceneCache::FPlane>; // by the file's channel index

	/** A texture of scene.textures; the packing refers to the names. */
	struct FOwnTexture
	{
		std::string Name;
		std::vector<std::string> Channels;
		FScenePacking Packing;
	};

	const FScenePacking* FindPacking(const std::string& Texture) const;
	FRDGTextureRef Register(FRDGBuilder& GraphBuilder, const FScenePacking& Packing);
	std::optional<FSource> FindSource(const FScenePackChannel& Channel) const;
	bool HasAnyChannel(const FScenePacking& Packing) const;
	std::optional<FFill> PlanFill(const FNeededSceneTexture& Needed) const;
	FError MakeMissingChannel(const std::string& Channel, const FNeededSceneTexture& Needed) const;
	std::vector<FFill> PlanFills(const std::vector<FNeededSceneTexture>& Needed);
	void ReadPlanes(const std::vector<int>& FileChannels);
	void CountDecoded(const std::vector<FSource>& Sources);
	void Fill(const FFill& Fill, const FScenePackContext& Context);
	std::string MakeKey(const FScenePacking& Packing, const FRHITexture& Texture) const;
	std::vector<FSceneRegion> GetRegions() const;

	std::deque<FOwnTexture> OwnTextures; // never moved
	const FConfigScene& Config;
	FImageFile File;
	FSceneCache* const Cache;
	double ScreenPercentage = 100.0;
	std::vector<FSceneRegion> Regions;
	std::optional<FSceneCamera> Camera;
	std::optional<double> DeltaTime;
	FLinearColor LightColor;
	std::vector<FSceneChannel> Channels;
	std::map<std::string, TRefCountPtr<FRHITexture>> Textures;
	std::map<std::string, bool> Filled;
	std::optional<FScenePackContext> KeptContext; // of UseKeptTextures
	std::map<std::string, std::string> Keys;      // by texture, where textures are kept; of one that was written: none
	std::map<std::string, std::vector<FNonFiniteChannel>> Kept; // textures that came filled, and what was found in them
	FPlanes Planes;                                             // read and not yet loaded
	std::vector<FNonFiniteChannel> NonFinite;
};

} // namespace Drydock
