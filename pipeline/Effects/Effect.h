// Defines FEffect, the description of one effect that decisions, gates, the chain, reports and measurements read. A new
// effect is a file that defines such a value, and a row in EffectList.inl.
#pragma once

#include "Effects/EffectFigures.h"
#include "EngineProfile.h"
#include "FinalPostProcessSettings.h"
#include "SceneFile/ViewContent.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FEffect;

enum class EEffect : uint8
{
#define DRYDOCK_EFFECT(Name) Name,
#include "Effects/EffectList.inl"
#undef DRYDOCK_EFFECT
	Num,
};

/** A member that has to be given: leaving it out of an initialiser does not compile. */
template<typename Type>
struct TRequired
{
	TRequired() = delete;
	template<typename From>
	requires(!std::is_same_v<std::remove_cvref_t<From>, TRequired>) constexpr TRequired(From&& InValue)
		: Value(static_cast<From&&>(InValue))
	{
	}
	constexpr operator const Type&() const { return Value; }
	constexpr const Type* operator->() const { return &Value; }
	constexpr const Type& operator*() const { return Value; }

	Type Value;
};

/** Whether an effect runs, and why. */
struct FEffectDecision
{
	const FEffect* Effect = nullptr;
	bool bActive = false;
	bool bConfigured = false; // the config asks for it: not running is worth a line
	std::string Reason;
	bool bNothingToDo = false; // not active only because of what the scene holds: running it would change nothing
	bool bByExtension = false; // active, and a view extension makes its passes
	std::optional<FIntRect> Region = {}; // of an effect that works on a part of the view: from its corner

	/** "Bloom", ...; as JSON and people name it. */
	DRYDOCK_API std::string GetName() const;
	DRYDOCK_API EEffect GetId() const;
};

/** The decision on that effect, or null. */
DRYDOCK_API const FEffectDecision* FindEffect(const std::vector<FEffectDecision>& Effects, EEffect Id);

/** Whether that effect runs. */
DRYDOCK_API bool IsEffectActive(const std::vector<FEffectDecision>& Effects, EEffect Id);

/** The conditions beside its settings that decide about a view's effects; made once, when the settings are blended. */
struct FViewConditions
{
	FEngineProfile Engine = GetDefaultEngineProfile();
	FEngineShowFlags ShowFlags;
	std::vector<FSettingGate> Gates;        // what show flags and console variables changed in the settings
	bool bSeparateTranslucency = false;     // the scene has it; known once its textures are registered
	bool bAutoExposure = false;             // asked for: see IsAutoExposureActive (Exposure.h)
	float ExposureScale = 1.0f;             // final; of an automatic exposure once the frame has run
	float PreExposure = 1.0f;               // that colours are stored with
	double ScreenPercentage = 100.0;        // of the config, whatever the show flag says
	std::vector<std::string> NamedSettings; // by a volume, the camera or --pp, sorted
	bool bOverlaid = false;                 // by engine overlays, whose passes no gate by content was made for
	bool bNoSkip = false;                   // neutral values do not keep an effect from running
};

/** A view's settings as they were blended. From SetupView on FViewInfo::FinalPostProcessSettings holds the only live
 * ones. */
struct FViewSettings : FViewConditions
{
	FFinalPostProcessSettings Settings; // after show flags and console variables
};

/** The inputs of decisions; refers to what a frame holds. */
struct FEffectInputs
{
	const FFinalPostProcessSettings& Settings;
	const FViewConditions& Conditions;
	std::span<const std::string> Extensions = {}; // classes of the view extensions that take part

	FEffectInputs(const FFinalPostProcessSettings& InSettings, const FViewConditions& InConditions,
		std::span<const std::string> InExtensions = {})
		: Settings(InSettings)
		, Conditions(InConditions)
		, Extensions(InExtensions)
	{
	}
	/** Inputs without a frame. */
	FEffectInputs(const FViewSettings& View)
		: FEffectInputs(View.Settings, View)
	{
	}

	/** Something in the config gives a setting whose name begins so. */
	DRYDOCK_API bool IsNamed(std::string_view Beginning) const;
	/** ": ShowFlag.Bloom is off" where a show flag or console variable changed a setting whose name begins so; or
	 * nothing. */
	DRYDOCK_API std::string DescribeGate(std::string_view Beginning) const;
	/** "ShowFlag.PostProcessing is off", or of Flag where that one is on; empty where both are. */
	DRYDOCK_API std::string FindShowFlagOff(bool bFlag, const char* Flag) const;
};

/** A setting that an effect reads, or all whose names begin so; of several claims on a setting the longest counts. */
struct FSettingClaim
{
	std::string_view Beginning;
	const char* NotBuilt = ""; // why it does nothing all the same; empty: it acts
};

constexpr const char* NoPassReadsIt = "no pass reads it; it is blended and reported all the same";

/** Positions of an effect's passes in the chain, from the scene's colour to the display. */
enum class EChainPlace : uint8
{
	Lighting, // first of all
	DepthOfField,
	BeforeTranslucency,
	Translucency, // separate translucency comes into the picture
	AfterTranslucency,
	TemporalAA, // before what next frame's reflections see
	MotionBlur,
	BeforeBloom, // the last that sees the scene alone, linear
	Exposure,
	Bloom,
	AfterBloom, // on the picture with bloom in it; the tonemapper then adds none
	Tonemap,
	AfterTonemap,
	AntiAliasing,
	Upscale,
};

/** Turn: of several effects in one place, the lower comes first. */
struct FChainPlace
{
	EChainPlace Place = EChainPlace::BeforeBloom;
	int32 Turn = 0;
};

/** Textures that outlive the graph because something is measured on them, by name. */
using FKeptTextures = std::map<std::string, FScreenPassTexture>;

/** The inputs from which an effect's passes are made. */
struct FEffectPassInputs
{
	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FEffectDecision& Decision;
	/** The picture so far; the result takes its place. */
	FScreenPassTexture SceneColor;
	/** Colour of the main light, relative. */
	FLinearColor LightColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	/** [Optional] Where the result has to go: the effect is the frame's last pass. */
	FScreenPassRenderTarget OverrideOutput;
	/** The view's scene textures, made when first asked for. */
	std::function<TRDGUniformBufferRef<FSceneTextureUniformParameters>()> GetSceneTextures;
	/** Takes the textures that the effect can be measured on. */
	FKeptTextures& Kept;
	/** The factor from the picture to the display: the fixed scale, or the last frame's metered one; 1 on the first. */
	float ExposureScale = 1.0f;

	/** The part of the view where the effect has something to do, counted from the view's corner. Not set: anywhere, or
	 * the picture no longer has the view's size. */
	DRYDOCK_API std::optional<FIntRect> GetRegion() const;
};

/** The inputs by which the scene's content may leave out or confine an effect that the settings call for. */
struct FGateInputs
{
	const FEffectInputs& Inputs;
	const FViewContent& Content;
	const std::vector<FEffectDecision>& Decided; // by settings alone
	const std::vector<FEffectDecision>& Gated;   // as far as effects stand before this one
};

/** The scene's say in an effect; a default one: none. */
struct FContentGate
{
	/** Asks which contents of the scene could leave the effect out or confine it. Called where the effect is active. */
	FContentQuestions (*Ask)(const FGateInputs& Gate, const FEffectDecision& Decision) = nullptr;
	/** Takes an active decision back, or gives it a region, where that changes no bit of any output. */
	void (*Gate)(const FGateInputs& Gate, FEffectDecision& Decision) = nullptr;
};

/** How an effect is measured; a default one: not at all. */
struct FMeasurement
{
	/** Names of kept textures that it is measured on, all of which must be there. */
	std::span<const char* const> Textures;
	/** Figures and pictures of what it did, on request and after the frame. */
	FEffectFigures (*Measure)(const FMeasureInputs& Inputs) = nullptr;
};

/** All that the house asks of an effect. */
struct FEffect
{
	TRequired<EEffect> Id;
	/** As JSON, the command line and people name it. */
	TRequired<const char*> Name;
	/** One sentence for `drydock list effects`. */
	TRequired<const char*> Doc;
	/** Every setting that its passes or decisions read and no other effect owns. */
	TRequired<std::span<const FSettingClaim>> Settings;
	/** It may make a pixel of the scene's colour brighter before bloom sees it: bloom is then not left out for want of
	 * bright pixels. */
	TRequired<bool> bMayBrightenBeforeBloom;
	/** Decides from settings, show flags and console variables alone. */
	TRequired<FEffectDecision (*)(const FEffect& Effect, const FEffectInputs& Inputs)> Decide;
	TRequired<FContentGate> Content;
	/** Describes the other effects for the reason, once all are decided and gated; null: nothing. The text is appended
	 * where the effect is active. */
	TRequired<std::string (*)(const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Effects)> Complete;
	TRequired<FChainPlace (*)()> GetPlace;
	/** Its passes, from picture to picture; null: the chain itself makes them (PostProcessingChain.cpp). */
	TRequired<FScreenPassTexture (*)(const FEffectPassInputs& Inputs)> AddPasses;
	TRequired<FMeasurement> Measurement;
};

constexpr std::span<const FSettingClaim> NoSettings = {};

// The value of each effect, defined in the file of its name.
#define DRYDOCK_EFFECT(Name) extern const FEffect G##Name##Effect;
#include "Effects/EffectList.inl"
#undef DRYDOCK_EFFECT

} // namespace Drydock
