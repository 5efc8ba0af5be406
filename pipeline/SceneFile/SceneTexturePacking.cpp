// Packs channels into scene textures, row by row of one table. Source of the encodings: engine
// DeferredShadingCommon.ush, Common.ush.
#include "SceneFile/SceneTexturePacking.h"

#include "Math/ToInteger.h"
#include "RangeTools.h"
#include "SceneFile/SceneCamera.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

FLinearColor PackColor(const FScenePackValues& Values, const FScenePackContext& Context)
{
	const float Scale = Context.PreExposure;
	return FLinearColor(Values[0] * Scale, Values[1] * Scale, Values[2] * Scale, Values[3]);
}

/** To reversed device depth. */
FLinearColor PackDepth(const FScenePackValues& Values, const FScenePackContext& Context)
{
	const double Centimetres = Context.Units.bDepthInCentimetres ? 1.0 : 100.0;
	return FLinearColor(MakeDeviceDepth(static_cast<double>(Values[0]) * Centimetres), 0.0f, 0.0f, 0.0f);
}

/** 0, where no object has custom depth, is as far as can be. */
FLinearColor PackCustomDepth(const FScenePackValues& Values, const FScenePackContext& Context)
{
	return Values[0] > 0.0f ? PackDepth(Values, Context) : FLinearColor(0.0f, 0.0f, 0.0f, 0.0f);
}

/** In green, as stencil is read. */
FLinearColor PackCustomStencil(const FScenePackValues& Values, const FScenePackContext&)
{
	return FLinearColor(
		0.0f, std::isfinite(Values[0]) ? std::clamp(std::round(Values[0]), 0.0f, 255.0f) : 0.0f, 0.0f, 0.0f);
}

/** A right-handed Y axis points the other way. No surface: all bits 0, as a cleared G-buffer. */
FLinearColor PackNormal(const FScenePackValues& Values, const FScenePackContext& Context)
{
	const float HalfY = Context.Units.bNormalIsLeftHanded ? 0.5f : -0.5f;
	const bool bSurface = Values[0] != 0.0f || Values[1] != 0.0f || Values[2] != 0.0f;
	return bSurface ? FLinearColor(Values[0] * 0.5f + 0.5f, Values[1] * HalfY + 0.5f, Values[2] * 0.5f + 0.5f, 0.0f)
					: FLinearColor(0.0f, 0.0f, 0.0f, 0.0f);
}

/** Metallic, specular, roughness; the id in the low four bits of alpha, the selective output mask above it is 0. */
FLinearColor PackMaterial(const FScenePackValues& Values, const FScenePackContext&)
{
	const long Id = std::isfinite(Values[3]) ? ToInteger<long>(std::round(Values[3])) : 0;
	return FLinearColor(Values[0], Values[1], Values[2], static_cast<float>(Id & 0xF) / 255.0f);
}

FLinearColor PackAsIs(const FScenePackValues& Values, const FScenePackContext&)
{
	return FLinearColor(Values[0], Values[1], Values[2], Values[3]);
}

FLinearColor PackCustomData(const FScenePackValues& Values, const FScenePackContext&)
{
	return FLinearColor(0.0f, 0.0f, Values[0], 0.0f);
}

/** The square-root encoding of velocities: finer near zero. Screen position -2..2. */
float EncodeVelocity(double Velocity)
{
	const double Rooted = std::copysign(std::sqrt(std::abs(Velocity)), Velocity) * std::sqrt(2.0);
	return static_cast<float>(Rooted * (0.499 * 0.5) + 32767.0 / 65535.0);
}

/** To screen position, y up. */
FLinearColor PackVelocity(const FScenePackValues& Values, const FScenePackContext& Context)
{
	if (Context.Units.bVelocityIsNdc)
	{
		return FLinearColor(
			EncodeVelocity(static_cast<double>(Values[0])), EncodeVelocity(static_cast<double>(Values[1])), 0.0f, 0.0f);
	}
	return FLinearColor(EncodeVelocity(2.0 * static_cast<double>(Values[0]) / Context.ViewSize.X),
		EncodeVelocity(-2.0 * static_cast<double>(Values[1]) / Context.ViewSize.Y), 0.0f, 0.0f);
}

/** A template, because some members have the type FRDGTextureMSAA. */
template<auto Member>
void Set(FSceneTextures& SceneTextures, FRDGTextureRef Texture)
{
	SceneTextures.*Member = Texture;
}

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr ETextureCreateFlags Read = ETextureCreateFlags::ShaderResource | ETextureCreateFlags::RenderTargetable;

} // namespace

const std::vector<FScenePacking>& GetScenePackings()
{
	static const std::vector<FScenePacking> Packings = {
		{"SceneColor", PF_FloatRGBA, Read | ETextureCreateFlags::UAV, Set<&FSceneTextures::Color>,
			{{{"R", {}}, {"G", {}}, {"B", {}}, {"A", 1.0f}}}, PackColor, FLinearColor(NaN, NaN, NaN, NaN), true},
		{"SceneDepthZ", PF_DepthStencil,
			ETextureCreateFlags::ShaderResource | ETextureCreateFlags::DepthStencilTargetable,
			Set<&FSceneTextures::Depth>, {{{"depth.Z", {}}}}, PackDepth, FLinearColor(1.0f, 0.0f, 0.0f, 0.0f)},
		{"SceneVelocity", PF_G16R16, Read, Set<&FSceneTextures::Velocity>, {{{"velocity.X", {}}, {"velocity.Y", {}}}},
			PackVelocity, FLinearColor(1.0f, 1.0f, 0.0f, 0.0f)},
		{"GBufferA", PF_A2B10G10R10, Read, Set<&FSceneTextures::GBufferA>,
			{{{"normal.X", {}}, {"normal.Y", {}}, {"normal.Z", {}}}}, PackNormal, FLinearColor(1.0f, 1.0f, 1.0f, 1.0f)},
		{"GBufferB", PF_B8G8R8A8, Read, Set<&FSceneTextures::GBufferB>,
			{{{"metallic", 0.0f}, {"specular", 0.5f}, {"roughness", 0.5f}, {"shadingmodel.ID", {}}}}, PackMaterial,
			FLinearColor(1.0f, 1.0f, 1.0f, 8.0f / 255.0f)},
		{"GBufferC", PF_B8G8R8A8, Read | ETextureCreateFlags::SRGB, Set<&FSceneTextures::GBufferC>,
			{{{"basecolor.R", {}}, {"basecolor.G", {}}, {"basecolor.B", {}}, {"ambientocclusion", 1.0f}}}, PackAsIs,
			FLinearColor(1.0f, 0.0f, 1.0f, 0.0f)},
		{"GBufferD", PF_B8G8R8A8, Read, Set<&FSceneTextures::GBufferD>, {{{"custommask.B", {}}}}, PackCustomData,
			FLinearColor(1.0f, 1.0f, 1.0f, 1.0f)},
		{"ToonShadow", PF_R8G8B8A8, Read, Set<&FSceneTextures::ToonShadow>, {{{"shadow.R", {}}, {"shadow.G", {}}}},
			PackAsIs, FLinearColor(0.0f, 0.0f, 1.0f, 1.0f)},
		{"SeparateTranslucency", PF_FloatRGBA, Read, Set<&FSceneTextures::SeparateTranslucency>,
			{{{"translucency.R", {}}, {"translucency.G", {}}, {"translucency.B", {}}, {"translucency.A", {}}}},
			PackColor, FLinearColor(NaN, NaN, NaN, NaN), true, true},
		{"CustomDepth", PF_DepthStencil,
			ETextureCreateFlags::ShaderResource | ETextureCreateFlags::DepthStencilTargetable,
			Set<&FSceneTextures::CustomDepth>, {{{"customdepth.Z", {}}}}, PackCustomDepth,
			FLinearColor(1.0f, 0.0f, 0.0f, 0.0f), false, true},
		{"CustomStencil", PF_R8G8_UINT, Read, Set<&FSceneTextures::CustomStencilTexture>, {{{"customstencil.ID", {}}}},
			PackCustomStencil, FLinearColor(255.0f, 255.0f, 0.0f, 0.0f), false, true},
	};
	return Packings;
}

const FScenePacking* FindScenePacking(const std::string& Texture)
{
	const std::vector<FScenePacking>& Packings = GetScenePackings();
	return FindItem(Packings, Texture, &FScenePacking::Name);
}

FScenePacking MakeOwnScenePacking(const std::string& Texture, const std::vector<std::string>& Channels)
{
	constexpr EPixelFormat Formats[] = {PF_R32_FLOAT, PF_G32R32F, PF_A32B32G32R32F, PF_A32B32G32R32F};
	check(!Channels.empty() && Channels.size() <= std::size(Formats));
	FScenePacking Packing = {
		Texture.c_str(), Formats[Channels.size() - 1], Read, nullptr, {}, PackAsIs, FLinearColor(NaN, NaN, NaN, NaN)};
	for (size_t Slot = 0; Slot < Channels.size(); ++Slot)
	{
		Packing.Channels[Slot].Name = Channels[Slot].c_str();
	}
	return Packing;
}

std::vector<std::string> SplitChannelNames(const std::string& Names)
{
	return ToVector<std::string>(SplitText(Names, ','), [](const std::string& Name) { return Trim(Name); });
}

const std::vector<std::string>& GetSceneChannelNames()
{
	static const std::vector<std::string> Names = []
	{
		std::vector<std::string> All;
		for (const FScenePacking& Packing : GetScenePackings())
		{
			for (const FScenePackChannel& Channel : Packing.Channels)
			{
				if (Channel.Name != nullptr)
				{
					All.emplace_back(Channel.Name);
				}
			}
		}
		return All;
	}();
	return Names;
}

} // namespace Drydock
