// Measures what of a scene could leave an effect nothing to do.
#include "SceneFile/SceneContent.h"

#include "Math/ToInteger.h"
#include "SceneFile/ChannelValues.h"
#include "SceneFile/SceneFile.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** SHADINGMODELID_CLOTH of ShadingCommon.ush, as PackMaterial stores it. */
constexpr long ToonShadingModel = 8;
constexpr long ShadingModelMask = 0xF;

bool IsToon(float Id)
{
	return std::isfinite(Id) && (ToInteger<long>(std::round(Id)) & ShadingModelMask) == ToonShadingModel;
}

/** Sums of such values are exact in double, in whichever order. */
bool IsExactlySummed(float Mask)
{
	return Mask == 0.0f || (std::abs(Mask) >= 1.0f / 256.0f && std::abs(Mask) <= 256.0f); // false for NaN
}

template<typename TPredicate>
bool Holds(const FIntRect& Area, const TPredicate& IsMarked)
{
	return FindBounds(Area, IsMarked).Area() > 0;
}

FIntRect FindGlowMask(const FChannelValues& Mask, const FIntRect& Area)
{
	const bool bExact = !Holds(Area, [&](int X, int Y) { return !IsExactlySummed(Mask.Get(X, Y)); });
	return bExact ? FindBounds(Area, [&](int X, int Y) { return Mask.Get(X, Y) != 0.0f; }) : Area;
}

std::optional<double> FindBrightest(const std::vector<FChannelValues>& Colors, const FIntRect& Area)
{
	float Brightest = 0.0f;
	bool bFinite = true;
	for (const FChannelValues& Color : Colors)
	{
		for (int Y = Area.Min.Y; Y < Area.Max.Y; ++Y)
		{
			for (int X = Area.Min.X; X < Area.Max.X; ++X)
			{
				const float Value = Color.Get(X, Y);
				bFinite = bFinite && std::isfinite(Value);
				Brightest = std::max(Brightest, Value);
			}
		}
	}
	return bFinite ? std::optional(static_cast<double>(Brightest)) : std::nullopt;
}

} // namespace

FIntRect MapBounds(const FIntRect& Bounds, const FSceneRegion& Region)
{
	const FIntPoint Size = Region.Target.Size();
	if (Bounds.Area() == 0)
	{
		return FIntRect();
	}
	return Region.Source.Size() == Size ? Bounds - Region.Source.Min : FIntRect(FIntPoint::ZeroValue, Size);
}

namespace
{

/** Answers from these channels. */
FViewContent MeasureChannels(
	const std::map<std::string, FChannelValues>& Channels, const FSceneRegion& Region, FIntPoint Size)
{
	const auto Has = [&](std::initializer_list<const char*> Asked)
	{
		return std::all_of(Asked.begin(), Asked.end(), [&](const char* Name) { return Channels.count(Name) > 0; });
	};

	FViewContent Content;
	Content.Size = Size;
	if (Has({"shadingmodel.ID"}))
	{
		const FChannelValues& Ids = Channels.at("shadingmodel.ID");
		Content.Toon =
			MapBounds(FindBounds(Region.Source, [&](int X, int Y) { return IsToon(Ids.Get(X, Y)); }), Region);
	}
	if (Has({"custommask.B"}))
	{
		Content.GlowMask = MapBounds(FindGlowMask(Channels.at("custommask.B"), Region.Source), Region);
	}
	if (Has({"velocity.X", "velocity.Y"}))
	{
		const FChannelValues& VelocityX = Channels.at("velocity.X");
		const FChannelValues& VelocityY = Channels.at("velocity.Y");
		Content.bStill = !Holds(
			Region.Source, [&](int X, int Y) { return VelocityX.Get(X, Y) != 0.0f || VelocityY.Get(X, Y) != 0.0f; });
	}
	if (Has({"R", "G", "B"}))
	{
		Content.Brightest = FindBrightest({Channels.at("R"), Channels.at("G"), Channels.at("B")}, Region.Source);
	}
	return Content;
}

/** Everything that MeasureChannels reads. A plane is known by its address as long as the cache holds it. */
std::string MakeKey(const std::map<std::string, FChannelValues>& Channels, const FSceneRegion& Region)
{
	std::string Key;
	for (const FIntRect& Rect : {Region.Source, Region.Target})
	{
		for (const int32 Edge : {Rect.Min.X, Rect.Min.Y, Rect.Max.X, Rect.Max.Y})
		{
			Key += std::to_string(Edge) + " ";
		}
	}
	for (const auto& [Name, Values] : Channels)
	{
		Key += Name + " " + std::to_string(reinterpret_cast<uintptr_t>(Values.Values)) + " " +
			   NumberText(Values.Constant) + (Values.bZeroNonFinite ? " zero " : " ");
	}
	return Key;
}

} // namespace

FViewContent MeasureViewContent(FSceneFile& Scene, const FIntRect& ViewRect, const FContentQuestions& Questions)
{
	std::vector<std::string> Names;
	const auto Ask = [&](bool bAsked, std::initializer_list<const char*> Channels)
	{
		Names.insert(Names.end(), Channels.begin(), bAsked ? Channels.end() : Channels.begin());
	};
	Ask(Questions.bToon, {"shadingmodel.ID"});
	Ask(Questions.bGlowMask, {"custommask.B"});
	Ask(Questions.bStill, {"velocity.X", "velocity.Y"});
	Ask(Questions.bBrightest, {"R", "G", "B"});
	const std::map<std::string, FChannelValues> Channels = Scene.ReadChannels(Names);
	const FSceneRegion Region = Scene.FindRegion(ViewRect);
	FSceneCache* const Cache = Scene.GetCache();
	if (Cache == nullptr)
	{
		return MeasureChannels(Channels, Region, ViewRect.Size());
	}
	const std::string Key = MakeKey(Channels, Region);
	std::optional<FViewContent> Content = Cache->FindContent(Key);
	if (!Content)
	{
		Content = MeasureChannels(Channels, Region, ViewRect.Size());
		Cache->KeepContent(Key, *Content);
	}
	return *Content;
}

} // namespace Drydock
